package glint.desktop.window;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;

/** The buttons of the window, each with its key. */
final class Controls {

  private final JToolBar bar = new JToolBar();
  private final JRootPane root;

  /** Makes an empty row of buttons, whose keys work anywhere in a window. */
  Controls(JRootPane root) {
    this.root = root;
    bar.setFloatable(false);
  }

  /** Adds a button and returns it; its name is that of the key, such as SPACE. */
  JButton add(String text, String key, Runnable work) {
    Action action =
        new AbstractAction(text) {
          private static final long serialVersionUID = 1;

          @Override
          public void actionPerformed(ActionEvent e) {
            work.run();
          }
        };
    root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), text);
    root.getActionMap().put(text, action);
    JButton button = bar.add(action);
    button.setName(text);
    button.setFocusable(false);
    button.setToolTipText(text + " (" + key.toLowerCase(java.util.Locale.ROOT) + ")");
    return button;
  }

  JToolBar bar() {
    return bar;
  }
}

package glint.desktop.window;

import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRootPane;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;

/** What the window can do: all of it in menus and by keys, and some by buttons, too. */
final class Controls {

  private final JMenuBar menus = new JMenuBar();
  private final JToolBar bar = new JToolBar();
  private final List<Command> commands = new ArrayList<>();
  private final JRootPane root;
  private JMenu menu;

  /**
   * One thing to do; immutable.
   *
   * @param menu the menu that it stands in
   * @param key what to press, in words
   */
  record Command(String menu, String text, String key) {}

  /** Makes empty menus and an empty row of buttons, whose keys work anywhere in a window. */
  Controls(JRootPane root) {
    this.root = root;
    bar.setFloatable(false);
    root.setJMenuBar(menus);
  }

  /** Begins a menu, to which all that follows belongs. */
  void menu(String name) {
    menu = new JMenu(name);
    menu.setMnemonic(name.charAt(0));
    menus.add(menu);
  }

  /** Adds a menu item and a button and returns that; its name is the text. */
  JButton add(String text, String keys, Runnable work) {
    Action action = item(text, keys, work);
    JButton button = bar.add(action);
    button.setName(text);
    button.setFocusable(false);
    button.setToolTipText(text + " (" + Keys.words(Keys.of(keys).get(0)) + ")");
    return button;
  }

  /** Adds a menu item; the first of its keys, as {@link Keys#of} has them, is shown. */
  Action item(String text, String keys, Runnable work) {
    Action action =
        new AbstractAction(text) {
          private static final long serialVersionUID = 1;

          @Override
          public void actionPerformed(ActionEvent e) {
            work.run();
          }
        };
    List<KeyStroke> strokes = Keys.of(keys);
    for (KeyStroke stroke : strokes) {
      root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, text);
    }
    root.getActionMap().put(text, action);
    JMenuItem item = menu.add(action);
    item.setAccelerator(strokes.get(0));
    commands.add(new Command(menu.getText(), text, Keys.words(strokes.get(0))));
    return action;
  }

  /** Parts what was added from what follows. */
  void gap() {
    menu.addSeparator();
    if (!(bar.getComponent(bar.getComponentCount() - 1) instanceof JToolBar.Separator)) {
      bar.addSeparator();
    }
  }

  /** Returns all that was added, in order. */
  List<Command> commands() {
    return List.copyOf(commands);
  }

  JToolBar bar() {
    return bar;
  }
}

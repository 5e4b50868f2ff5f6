package glint.desktop.window;

import java.awt.Insets;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JRootPane;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;
import javax.swing.KeyStroke;

/** What the window can do: all of it in menus and by keys, and some by buttons, too. */
final class Controls {

  private final JMenuBar menus = new JMenuBar();
  private final JToolBar bar = new JToolBar();
  private final List<Command> commands = new ArrayList<>();
  private final JRootPane root;
  private JMenu menu;
  private boolean menuGap;
  private boolean barGap;

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
    bar.setLayout(new Rows());
    root.setJMenuBar(menus);
  }

  /** Begins a menu, to which all that follows belongs, and returns it. */
  JMenu menu(String name) {
    menu = new JMenu(name);
    menu.setMnemonic(name.charAt(0));
    menus.add(menu);
    menuGap = false;
    return menu;
  }

  /** Adds a menu item and a button and returns that; its name is the text. */
  JButton add(String text, String keys, Runnable work) {
    return button(new JButton(item(text, keys, work)), text, keys);
  }

  /** Adds a menu item; the first of its keys, as {@link Keys#of} has them, is shown. */
  Action item(String text, String keys, Runnable work) {
    Action action = action(text, keys, work);
    accelerate(menu.add(action), keys);
    return action;
  }

  /** Adds a choice, one of which holds at a time, as a menu item and a button; the first holds. */
  void choice(ButtonGroup group, String text, String keys, Runnable work) {
    Action action = action(text, keys, work);
    action.putValue(Action.SELECTED_KEY, group.getButtonCount() == 0);
    accelerate(menu.add(new JRadioButtonMenuItem(action)), keys);
    group.add(button(new JToggleButton(action), text, keys));
  }

  /** Parts what was added from what follows, in the menu and among the buttons. */
  void gap() {
    menuGap = true;
    barGap = true;
  }

  /** Returns all that was added, in order. */
  List<Command> commands() {
    return List.copyOf(commands);
  }

  JToolBar bar() {
    return bar;
  }

  private Action action(String text, String keys, Runnable work) {
    if (menuGap) {
      menu.addSeparator();
      menuGap = false;
    }
    Action action =
        new AbstractAction(text) {
          private static final long serialVersionUID = 1;

          @Override
          public void actionPerformed(ActionEvent e) {
            if (getValue(SELECTED_KEY) != null) {
              putValue(SELECTED_KEY, true);
            }
            work.run();
          }
        };
    List<KeyStroke> strokes = Keys.of(keys);
    for (KeyStroke stroke : strokes) {
      root.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, text);
    }
    root.getActionMap().put(text, action);
    commands.add(new Command(menu.getText(), text, Keys.words(strokes.get(0))));
    return action;
  }

  private static void accelerate(JMenuItem item, String keys) {
    item.setAccelerator(Keys.of(keys).get(0));
  }

  private <B extends AbstractButton> B button(B button, String text, String keys) {
    button.setName(text);
    button.setFocusable(false);
    button.setMargin(new Insets(4, 5, 4, 5));
    button.setToolTipText(text + " (" + Keys.words(Keys.of(keys).get(0)) + ")");
    if (barGap) {
      bar.addSeparator();
      barGap = false;
    }
    bar.add(button);
    return button;
  }
}

package glint.desktop.window;

import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.swing.KeyStroke;

/** Keys by their names, and in words for people. */
final class Keys {

  private static final Map<Integer, String> WORDS =
      Map.of(
          KeyEvent.VK_PLUS, "+",
          KeyEvent.VK_MINUS, "-",
          KeyEvent.VK_SLASH, "/",
          KeyEvent.VK_COMMA, ",",
          KeyEvent.VK_PERIOD, ".",
          KeyEvent.VK_ESCAPE, "Esc",
          KeyEvent.VK_PAGE_UP, "Page up",
          KeyEvent.VK_PAGE_DOWN, "Page down");

  private Keys() {}

  /**
   * Returns the keys that a text names, such as "menu S, F2": as KeyStroke has it, and "menu" for
   * the key that goes with commands on this system.
   */
  static List<KeyStroke> of(String names) {
    int mask = Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    String menu = mask == InputEvent.META_DOWN_MASK ? "meta" : "ctrl";
    return Arrays.stream(names.split(", "))
        .map(name -> KeyStroke.getKeyStroke(name.replace("menu", menu)))
        .toList();
  }

  /** Returns what stands on the keyboard. */
  static String words(KeyStroke key) {
    String modifiers = InputEvent.getModifiersExText(key.getModifiers());
    String name = WORDS.getOrDefault(key.getKeyCode(), KeyEvent.getKeyText(key.getKeyCode()));
    return modifiers.isEmpty() ? name : modifiers + "+" + name;
  }
}

package glint.desktop.window;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;

/** The look of the window. */
enum Theme {
  LIGHT,
  DARK;

  /** Returns the look with a name; the light one if there is none. */
  static Theme named(String name) {
    return DARK.name().equals(name) ? DARK : LIGHT;
  }

  /** Gives this look to every window, those that are open included. */
  void apply() {
    FlatLaf.setup(this == LIGHT ? new FlatLightLaf() : new FlatDarkLaf());
    FlatLaf.updateUI();
  }

  /** Returns the other one. */
  Theme other() {
    return this == LIGHT ? DARK : LIGHT;
  }
}

package glint.desktop.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;

/** Lays parts in rows, as many as the width takes; the last part has what its row leaves. */
final class Rows implements LayoutManager {

  @Override
  public void addLayoutComponent(String name, Component part) {}

  @Override
  public void removeLayoutComponent(Component part) {}

  /** Returns the height of all rows in the width that there is, or of one if there is none yet. */
  @Override
  public Dimension preferredLayoutSize(Container parts) {
    return lay(parts, false);
  }

  @Override
  public Dimension minimumLayoutSize(Container parts) {
    return lay(parts, false);
  }

  @Override
  public void layoutContainer(Container parts) {
    lay(parts, true);
  }

  private static Dimension lay(Container parts, boolean move) {
    Insets rim = parts.getInsets();
    int end = parts.getWidth() > 0 ? parts.getWidth() - rim.right : Integer.MAX_VALUE;
    int height = 0;
    for (Component part : parts.getComponents()) {
      height = Math.max(height, part.getPreferredSize().height);
    }
    int x = rim.left;
    int y = rim.top;
    int widest = x;
    int last = parts.getComponentCount() - 1;
    for (int i = 0; i <= last; i++) {
      Component part = parts.getComponent(i);
      if (x > rim.left && part.getMinimumSize().width > end - x) {
        x = rim.left;
        y += height;
      }
      int width = i == last && move ? end - x : part.getPreferredSize().width;
      if (move) {
        part.setBounds(x, y, width, height);
      }
      x += width;
      widest = Math.max(widest, x);
    }
    return new Dimension(widest + rim.right, y + height + rim.bottom);
  }
}

package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

class RowsTest {

  private final JPanel parts = new JPanel(new Rows());

  private void add(int width, int least, int height) {
    JPanel part = new JPanel();
    part.setPreferredSize(new Dimension(width, height));
    part.setMinimumSize(new Dimension(least, height));
    parts.add(part);
  }

  /** Sets the width as a layout does that asks for the height then. */
  private List<Rectangle> at(int width, int height) {
    parts.setSize(width, 1);
    assertEquals(height, parts.getPreferredSize().height);
    parts.setSize(width, height);
    parts.doLayout();
    return Arrays.stream(parts.getComponents()).map(Component::getBounds).toList();
  }

  @Test
  void rowsBreakWhereTheNextPartDoesNotFit() {
    parts.setBorder(BorderFactory.createEmptyBorder(1, 2, 3, 4));
    add(50, 50, 20);
    add(30, 30, 25);
    add(40, 0, 10);
    assertEquals(new Dimension(126, 29), parts.getPreferredSize());
    Rectangle first = new Rectangle(2, 1, 50, 25);
    Rectangle second = new Rectangle(52, 1, 30, 25);
    assertEquals(List.of(first, second, new Rectangle(82, 1, 114, 25)), at(200, 29));
    assertEquals(List.of(first, second, new Rectangle(82, 1, 0, 25)), at(86, 29));
    second = new Rectangle(2, 26, 30, 25);
    assertEquals(List.of(first, second, new Rectangle(32, 26, 49, 25)), at(85, 54));
    assertEquals(List.of(first, second, new Rectangle(32, 26, 0, 25)), at(36, 54));
  }
}

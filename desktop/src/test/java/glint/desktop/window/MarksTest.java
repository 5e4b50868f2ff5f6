package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class MarksTest {

  private static BufferedImage plain(int width, int height, Color color) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setColor(color);
    g.fillRect(0, 0, width, height);
    g.dispose();
    return image;
  }

  @Test
  void whatWasShownBeforeStaysWhereNothingIsFinished() {
    Marks marks = new Marks(Optional.of(plain(4, 3, Color.BLUE)));
    BufferedImage now = plain(40, 30, Color.RED);
    Rectangle first = new Rectangle(0, 0, 20, 15);
    Rectangle second = new Rectangle(20, 0, 20, 15);
    marks.begin(first);
    assertEquals(List.of(first), marks.inWork());
    assertEquals(Color.BLUE.getRGB(), marks.cover(now).getRGB(10, 10));
    marks.begin(second);
    assertEquals(List.of(second), marks.inWork());
    assertEquals(Color.RED.getRGB(), marks.cover(now).getRGB(19, 14));
    assertEquals(Color.BLUE.getRGB(), marks.cover(now).getRGB(20, 14));
    assertEquals(Color.BLUE.getRGB(), marks.cover(now).getRGB(19, 15));
    marks.whole();
    assertSame(now, marks.cover(now));
  }

  @Test
  void everyThreadWorksAtAPartOfItsOwn() throws InterruptedException {
    Marks marks = new Marks(Optional.empty());
    Rectangle left = new Rectangle(0, 0, 1, 1);
    Rectangle right = new Rectangle(1, 0, 1, 1);
    marks.begin(left);
    Thread other = new Thread(() -> marks.begin(right));
    other.start();
    other.join();
    assertEquals(2, marks.inWork().size());
    marks.begin(right);
    assertEquals(List.of(right, right), marks.inWork());
  }
}

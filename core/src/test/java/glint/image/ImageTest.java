package glint.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.color.Transfer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ImageTest {

  @Test
  void isBlackAtFirst() {
    Image image = new Image(4, 3);
    assertEquals(4, image.width());
    assertEquals(3, image.height());
    assertArrayEquals(new double[36], image.rgb());
  }

  @Test
  void holdsPixelsRowByRowFromTheTop() {
    Image image = new Image(4, 3);
    image.set(3, 1, 0.25, 0.5, 0.75);
    assertEquals(0.25, image.rgb()[21]);
    assertEquals(0.5, image.rgb()[22]);
    assertEquals(0.75, image.rgb()[23]);
  }

  @Test
  void averagesInLinearLightBeforeItEncodes() {
    Image image = new Image(2, 1);
    image.set(0, 0, 0.5, 1, 0); // half of the pixel covered in red
    image.set(1, 0, -1, 2, Double.NaN);
    assertArrayEquals(new int[] {0xffbcff00, 0xff00ff00}, image.toArgb(Transfer.SRGB));
    assertArrayEquals(new int[] {0xff7fff00, 0xff00ff00}, image.toArgb(Transfer.LINEAR));
  }

  @ParameterizedTest
  @CsvSource({"0, 1", "1, 0", "-1, 5", "100000, 100000", "2147483647, 2147483647"})
  void refusesSizesThatNoArrayHolds(int width, int height) {
    Exception e = assertThrows(IllegalArgumentException.class, () -> new Image(width, height));
    assertEquals("cannot hold an image of " + width + "x" + height, e.getMessage());
  }
}

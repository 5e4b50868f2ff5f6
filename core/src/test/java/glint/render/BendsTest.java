package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Transfer;
import glint.image.Image;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** How far radiance bends, row by row and pixel by pixel. */
class BendsTest {

  private static final LevelScale SCALE = LevelScale.of(Transfer.SRGB);

  @Property(tries = 200)
  void aRowOfPixelsTellsWhatSinglePixelsTell(
      @ForAll @IntRange(min = 1, max = 7) int width,
      @ForAll @IntRange(min = 1, max = 7) int height,
      @ForAll @IntRange(min = 1, max = 4) int things,
      @ForAll long seed) {
    Random random = new Random(seed);
    CornerGrid corners = new CornerGrid(width, height, false, false);
    for (int i = 0; i < corners.signature.length; i++) {
      corners.signature[i] = random.nextInt(things);
    }
    for (int i = 0; i < corners.rgb.length; i++) {
      corners.rgb[i] = random.nextDouble();
    }
    Image image = new Image(width, height);
    for (int i = 0; i < image.rgb().length; i++) {
      image.rgb()[i] = random.nextDouble();
    }
    Bends byRow = new Bends(corners, SCALE);
    for (int turn = 0; turn < 3 * height; turn++) {
      int y = turn < height ? turn : random.nextInt(height);
      byRow.turn(y);
      for (int x = 0; x < width; x++) {
        assertEquals(new Bends(corners, SCALE).error(x, y, image), byRow.error(x, y, image));
      }
    }
  }

  /** Of c·x² the trapezoidal rule errs by a twelfth of the second difference 2c. */
  @Property(tries = 50)
  void aParabolaBendsEverywhereAlike(@ForAll @IntRange(min = 1, max = 40) int bend) {
    double c = bend * 1e-3;
    CornerGrid corners = new CornerGrid(5, 4, false, false);
    for (int i = 0; i < corners.signature.length; i++) {
      int x = i % corners.stride;
      int y = i / corners.stride;
      corners.rgb[3 * i] = 0.2 + c * x * x / 5;
      corners.rgb[3 * i + 1] = 0.2 + c * y * y / 5;
      corners.rgb[3 * i + 2] = 0.2;
    }
    Image image = new Image(5, 4);
    LevelScale linear = LevelScale.of(Transfer.LINEAR);
    Bends bends = new Bends(corners, linear);
    for (int y = 0; y < 4; y++) {
      for (int x = 0; x < 5; x++) {
        for (int i = 0; i < 3; i++) {
          image.rgb()[3 * (5 * y + x) + i] = corners.mean(x, y, i);
        }
        double off = 255 * 2 * c / 5 / 12;
        assertEquals(2 * off * off / 3, bends.error(x, y, image), 0.02 * off * off);
      }
    }
  }
}

package glint.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.ByteImage;
import glint.image.Noise;
import glint.math.BadValueException;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Which colour of an image is seen at u and v. */
class ImageTextureTest {

  private static final ByteImage IMAGE = Noise.of(5, 3);

  private static ImageTexture texture(Wrap wrap) {
    return new ImageTexture(IMAGE, new Layout(1, 1, 0, 0, wrap), Optional.empty());
  }

  private static Texel at(ImageTexture texture, double u, double v) {
    Texel texel = new Texel();
    texel.u = u;
    texel.v = v;
    texture.at(texel);
    return texel;
  }

  /** Returns the linear value of a channel of a pixel. */
  private static double linear(int column, int row, int channel) {
    return Transfer.SRGB.decode(IMAGE.code(column, row, channel) / 255.0);
  }

  /** Returns the sum of four pixels, columns and rows as given, each with its weight. */
  private static Rgb sum(int left, int right, int upper, int lower, double s, double t) {
    double[] c = new double[3];
    for (int i = 0; i < 3; i++) {
      c[i] = (1 - s) * (1 - t) * linear(left, upper, i) + s * (1 - t) * linear(right, upper, i);
      c[i] += (1 - s) * t * linear(left, lower, i) + s * t * linear(right, lower, i);
    }
    return new Rgb(c[0], c[1], c[2]);
  }

  private static void assertNear(Rgb expected, Texel actual) {
    assertEquals(expected.r(), actual.r, 1e-12);
    assertEquals(expected.g(), actual.g, 1e-12);
    assertEquals(expected.b(), actual.b, 1e-12);
  }

  @Test
  void centresOfPixelsShowTheirColour() {
    for (Wrap wrap : Wrap.values()) {
      for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 5; column++) {
          Texel texel = at(texture(wrap), (column + 0.5) / 5, 1 - (row + 0.5) / 3);
          assertNear(sum(column, column, row, row, 0, 0), texel);
          assertEquals(column + 0.5, texel.x, 1e-12);
          assertEquals(2.5 - row, texel.y, 1e-12);
          assertTrue(texel.isOfImage);
        }
      }
    }
  }

  @Test
  void halfWayIsTheMeanOfLightNotOfCodes() {
    ByteImage image = new ByteImage(2, 1, new byte[] {0, 0, 0, (byte) 255, (byte) 255, 0});
    ImageTexture texture = new ImageTexture(image, Layout.ONCE, Optional.empty());
    assertNear(new Rgb(0.5, 0.5, 0), at(texture, 0.5, 0.5));
    assertNear(new Rgb(0.5, 0.5, 0), at(texture, 0, 0.1));
    assertNear(new Rgb(0.25, 0.25, 0), at(texture, 0.375, 0.9));
  }

  @Property(tries = 200)
  void betweenCentresColoursAreInterpolated(
      @ForAll @IntRange(min = 0, max = 3) int column,
      @ForAll @IntRange(min = 0, max = 1) int row,
      @ForAll @DoubleRange(min = 0, max = 1) double s,
      @ForAll @DoubleRange(min = 0, max = 1) double t) {
    for (Wrap wrap : Wrap.values()) {
      Texel texel = at(texture(wrap), (column + 0.5 + s) / 5, 1 - (row + 0.5 + t) / 3);
      assertNear(sum(column, column + 1, row, row + 1, s, t), texel);
    }
  }

  @Property(tries = 200)
  void beyondTheEdges(
      @ForAll @DoubleRange(min = 0, max = 1) double u,
      @ForAll @DoubleRange(min = 0, max = 1) double v,
      @ForAll @IntRange(min = -9, max = 9) int i,
      @ForAll @IntRange(min = -9, max = 9) int j) {
    ImageTexture repeat = texture(Wrap.REPEAT);
    assertNear(at(repeat, u, v).color(), at(repeat, u + i, v + j));
    ImageTexture mirror = texture(Wrap.MIRROR);
    double backU = i % 2 == 0 ? u : 1 - u;
    double backV = j % 2 == 0 ? v : 1 - v;
    assertNear(at(mirror, u, v).color(), at(mirror, backU + i, backV + j));
    ImageTexture clamp = texture(Wrap.CLAMP);
    double nearU = Math.min(Math.max(u + i, 0), 1);
    double nearV = Math.min(Math.max(v + j, 0), 1);
    assertNear(at(clamp, nearU, nearV).color(), at(clamp, u + i, v + j));
  }

  @Test
  void edgesShowWhatLiesBesideThem() {
    assertNear(sum(4, 0, 1, 1, 0.75, 0), at(texture(Wrap.REPEAT), 0.25 / 5, 0.5));
    assertNear(sum(4, 0, 1, 1, 0.25, 0), at(texture(Wrap.REPEAT), 4.75 / 5, 0.5));
    assertNear(sum(2, 2, 2, 0, 0, 0.75), at(texture(Wrap.REPEAT), 0.5, 1 - 0.25 / 3));
    assertNear(sum(2, 2, 2, 0, 0, 0.25), at(texture(Wrap.REPEAT), 0.5, 0.25 / 3));
    for (Wrap wrap : new Wrap[] {Wrap.CLAMP, Wrap.MIRROR}) {
      assertNear(sum(0, 0, 1, 1, 0, 0), at(texture(wrap), 0.25 / 5, 0.5));
      assertNear(sum(4, 4, 0, 0, 0, 0), at(texture(wrap), 1, 1));
      assertNear(sum(2, 2, 2, 2, 0, 0), at(texture(wrap), 0.5, 0));
    }
  }

  @Test
  void aPlaceBeyondAllNumbersIsTheOrigin() {
    for (Wrap wrap : Wrap.values()) {
      Rgb corner = at(texture(wrap), 0, 0).color();
      for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, -1 / 0.0}) {
        assertEquals(corner, at(texture(wrap), bad, bad).color());
      }
      for (double far : new double[] {1e300, -1e300, -1e-300, Math.nextDown(0.0)}) {
        Texel texel = at(texture(wrap), far, far);
        assertTrue(texel.r >= 0 && texel.r <= 1);
      }
    }
  }

  @Property(tries = 100)
  void scaleComesBeforeOffset(
      @ForAll @DoubleRange(min = -2, max = 2) double u,
      @ForAll @DoubleRange(min = -2, max = 2) double v) {
    Layout layout = new Layout(2, -4, 0.25, 0.5, Wrap.MIRROR);
    ImageTexture texture = new ImageTexture(IMAGE, layout, Optional.empty());
    Texel expected = at(texture(Wrap.MIRROR), 2 * u + 0.25, -4 * v + 0.5);
    Texel texel = at(texture, u, v);
    assertEquals(expected.color(), texel.color());
    assertEquals(5 * (2 * u + 0.25), texel.x, 1e-12);
    assertEquals(3 * (-4 * v + 0.5), texel.y, 1e-12);
  }

  @Test
  void valuesAreMultipliedAndRaisedInLinearLight() {
    ImageTexture texture = new ImageTexture(IMAGE, Layout.ONCE, Optional.empty(), 0.25, 2);
    Rgb plain = sum(1, 1, 2, 2, 0, 0);
    assertNear(plain.times(2).plus(Rgb.grey(0.25)), at(texture, 0.3, 0.5 / 3));
    ImageTexture dark = new ImageTexture(IMAGE, Layout.ONCE, Optional.empty(), -1, 1);
    assertEquals(Rgb.BLACK, at(dark, 0.3, 0.5 / 3).color());
    ImageTexture turned = new ImageTexture(IMAGE, Layout.ONCE, Optional.empty(), 1, -1);
    assertEquals(Rgb.WHITE, turned.most());
  }

  @Test
  void theMostIsThatOfTheBrightestPixel() {
    double[] most = new double[3];
    for (int i = 0; i < 45; i++) {
      most[i % 3] = Math.max(most[i % 3], linear(i / 3 % 5, i / 15, i % 3));
    }
    assertEquals(new Rgb(most[0], most[1], most[2]), texture(Wrap.REPEAT).most());
  }

  @Test
  void whatIsNoImageIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> new ByteImage(0, 1, new byte[0]));
    assertThrows(IllegalArgumentException.class, () -> new ByteImage(1, 1, new byte[4]));
    assertThrows(IllegalArgumentException.class, () -> ByteImage.checkSize(1 << 13, (1 << 13) + 1));
    assertThrows(IllegalArgumentException.class, () -> ByteImage.checkSize(1 << 30, 1 << 30));
    ByteImage.checkSize(1 << 13, 1 << 13);
    assertThrows(BadValueException.class, () -> new Layout(Double.NaN, 1, 0, 0, Wrap.REPEAT));
  }
}

package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.image.ByteImage;
import glint.image.Noise;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Texel;
import glint.optics.Wrap;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Images of any size on the screen are found to within the error accepted. */
class ImageErrorTest {

  private static final int SIZE = 24;
  private static final ByteImage NOISE = Noise.of(64, 64);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static RenderSettings settings(double levels) {
    return new RenderSettings(
        SIZE, SIZE, new Goal.Error(levels), 3, OptionalInt.empty(), 2, 8, Set.of());
  }

  /** Returns a view, one unit a pixel, down along z. */
  private static Scene.Builder view() {
    return new Scene.Builder("image")
        .size(SIZE, SIZE)
        .camera(Camera.of(v(0, 0, 9), Vector3d.ZERO, v(0, 1, 0), new Orthographic(SIZE)))
        .light(new Light.Ambient(Rgb.WHITE));
  }

  private static ImageTexture texture(ByteImage image, double perUnit) {
    double scale = SIZE * perUnit / image.width();
    return new ImageTexture(
        image, new Layout(scale, scale, 0.3, 0.7, Wrap.REPEAT), Optional.empty());
  }

  /** Returns the image on all that is seen. */
  private static Quad screen() {
    return new Quad(v(-SIZE / 2.0, -SIZE / 2.0, 0), v(SIZE, 0, 0), v(0, SIZE, 0));
  }

  /** Returns the RMS error of a picture, in levels, by as many points as tell the truth. */
  private static double error(double[] rgb, ImageTexture texture) {
    int n = 32;
    double sum = 0;
    Texel texel = new Texel();
    for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
      int column = pixel % SIZE;
      int row = pixel / SIZE;
      double[] mean = new double[3];
      for (int i = 0; i < n * n; i++) {
        int down = i / n;
        texel.u = (column + (i % n + 0.5) / n) / SIZE;
        texel.v = 1 - (row + (down + 0.5) / n) / SIZE;
        texture.at(texel);
        mean[0] += texel.r / (n * n);
        mean[1] += texel.g / (n * n);
        mean[2] += texel.b / (n * n);
      }
      for (int c = 0; c < 3; c++) {
        double off = Transfer.SRGB.level(mean[c]) - Transfer.SRGB.level(rgb[3 * pixel + c]);
        sum += off * off / (3 * SIZE * SIZE);
      }
    }
    return Math.sqrt(sum);
  }

  /** From near, where it is smooth, to far; what is smooth is not sampled, but for audits. */
  @ParameterizedTest
  @CsvSource({"0.02, 2", "0.2, 60", "0.6, 24", "0.9, 40", "1.7, 90", "7.9, 600"})
  void noiseIsAsExactAsClaimed(double perPixel, double mostSamples) {
    ImageTexture texture = texture(NOISE, perPixel);
    Scene scene = view().place(Placement.of(screen(), Material.WHITE.textured(texture))).build();
    RenderResult result = new Renderer(Prepared.of(scene), settings(1)).render(Progress.NONE);
    double truth = error(result.image().rgb(), texture);
    double claimed = result.statistics().samplingError();
    assertTrue(truth <= 1, () -> truth + " levels");
    assertTrue(truth <= claimed, () -> truth + " levels, claimed " + claimed);
    double samples = result.statistics().meanSamples();
    assertTrue(samples <= mostSamples, () -> samples + " samples");
  }

  /** Corners and middles of all pixels show the same: white squares on black, one each. */
  @Test
  void whatAllCornersMissIsFound() {
    byte[] rgb = new byte[3 * 8 * 8];
    for (int i = 0; i < rgb.length; i++) {
      int x = i / 3 % 8;
      int y = i / 24;
      rgb[i] = (byte) ((x == 1 || x == 2) && (y == 5 || y == 6) ? 255 : 0);
    }
    ImageTexture texture =
        new ImageTexture(
            new ByteImage(8, 8, rgb), new Layout(SIZE, SIZE, 0, 0, Wrap.REPEAT), Optional.empty());
    Scene scene = view().place(Placement.of(screen(), Material.WHITE.textured(texture))).build();
    RenderResult result = new Renderer(Prepared.of(scene), settings(1)).render(Progress.NONE);
    double truth = error(result.image().rgb(), texture);
    assertTrue(truth <= 1, () -> truth + " levels");
  }

  private static int leaps(Scene.Builder scene, boolean images) {
    Prepared prepared = Prepared.of(scene.build());
    Probe probe = new Probe(prepared, settings(1).following(1e-6), (PixelWatch) null);
    CornerGrid corners = new CornerGrid(SIZE, SIZE, images, false);
    for (int i = 0; i < (SIZE + 1) * (SIZE + 1); i++) {
      corners.trace(probe, LevelScale.of(Transfer.SRGB), i % (SIZE + 1), i / (SIZE + 1));
    }
    int count = 0;
    for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
      count += corners.leapsOverDetail(pixel % SIZE, pixel / SIZE) ? 1 : 0;
    }
    return count;
  }

  @Test
  void detailIsLeaptOverFromHalfAPixelOfTheImageOn() {
    for (double perUnit : new double[] {0.49, 0.51, -0.49, -0.51}) {
      Material near = Material.WHITE.textured(texture(NOISE, perUnit));
      int expected = Math.abs(perUnit) > 0.5 ? SIZE * SIZE : 0;
      assertEquals(expected, leaps(view().place(Placement.of(screen(), near)), true));
      assertEquals(0, leaps(view().place(Placement.of(screen(), near)), false));
    }
    assertEquals(0, leaps(view().place(Placement.of(screen(), Material.WHITE)), true));
  }

  /** One image and its twin in a mirror, which move against each other on the screen. */
  @Test
  void whatAMirrorShowsIsLeaptOverToo() {
    Material plain = new Material(Rgb.BLACK, Rgb.WHITE, Rgb.BLACK, 1, Rgb.grey(0.5), Rgb.BLACK);
    Plane sky = new Plane(v(0, 0, 20), v(0, 0, 1));
    ImageTexture papered =
        new ImageTexture(
            NOISE, new Layout(-0.4 / 64, -0.4 / 64, 0, 0, Wrap.REPEAT), Optional.empty());
    Scene.Builder scene = view().place(Placement.of(screen(), plain));
    scene.place(Placement.of(sky, Material.WHITE.textured(papered)));
    assertEquals(0, leaps(scene, true));
    for (double each : new double[] {-1, 1}) {
      ImageTexture fine =
          new ImageTexture(
              NOISE, new Layout(each / 64, each / 64, 0, 0, Wrap.REPEAT), Optional.empty());
      scene = view().place(Placement.of(screen(), plain));
      scene.place(Placement.of(sky, Material.WHITE.textured(fine)));
      assertEquals(SIZE * SIZE, leaps(scene, true));
      scene = view().place(Placement.of(screen(), plain.textured(texture(NOISE, 1))));
      scene.place(Placement.of(sky, Material.WHITE.textured(fine)));
      assertEquals(SIZE * SIZE, leaps(scene, true));
    }
  }
}

package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.image.Noise;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Wrap;
import glint.scene.Camera;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is found from an image is what rays would find. */
class InlayTest {

  private static final int SIZE = 20;
  private static final LevelScale SCALE = LevelScale.of(Transfer.SRGB);
  private static final Quad FLOOR =
      new Quad(new Vector3d(-9, -2, -18), new Vector3d(18, 0, 0), new Vector3d(0, 0, 16));

  /** Returns an image, repeated so many times, on something under two lights, in perspective. */
  private static Prepared scene(Surface surface, double times, Vector3d eye) {
    Layout layout = new Layout(times, times, 0.3, 0.7, Wrap.REPEAT);
    ImageTexture texture = new ImageTexture(Noise.of(32, 32), layout, Optional.empty());
    Material dull =
        new Material(
            new Rgb(0.1, 0.2, 0.3), Rgb.grey(0.7), Rgb.grey(0.2), 20, Rgb.grey(0.1), Rgb.BLACK);
    Scene.Builder scene =
        new Scene.Builder("image")
            .size(SIZE, SIZE)
            .camera(
                Camera.of(
                    eye,
                    new Vector3d(0, -1.5, -5),
                    new Vector3d(0, 1, 0),
                    new Perspective(40, false, 0)))
            .light(new Light.Ambient(Rgb.grey(0.3)))
            .light(new Light.Point(new Vector3d(3, 4, -5), new Rgb(0.6, 0.5, 0.4), false));
    return Prepared.of(scene.place(Placement.of(surface, dull.textured(texture))).build());
  }

  private static Probe probe(Prepared scene) {
    RenderSettings settings =
        new RenderSettings(SIZE, SIZE, new Goal.Error(1), 3, OptionalInt.empty(), 2, 8, Set.of());
    return new Probe(scene, settings.following(1e-9));
  }

  private static CornerGrid corners(Probe probe) {
    CornerGrid corners = new CornerGrid(SIZE, SIZE, true, false);
    for (int i = 0; i < corners.stride * corners.rows; i++) {
      corners.trace(probe, SCALE, i % corners.stride, i / corners.stride);
    }
    return corners;
  }

  private static boolean isSmooth(CornerGrid corners, int x, int y) {
    return corners.crossings(x, y) == 0;
  }

  /** Returns the mean of many rays through a pixel, by channel. */
  private static double[] traced(Probe probe, int x, int y) {
    int n = 24;
    double[] mean = new double[3];
    for (int i = 0; i < n * n; i++) {
      int row = i / n;
      probe.trace(x + (i % n + 0.5) / n, y + (row + 0.5) / n);
      mean[0] += probe.r() / (n * n);
      mean[1] += probe.g() / (n * n);
      mean[2] += probe.b() / (n * n);
    }
    return mean;
  }

  /** From some pixels of the image in one of the picture to some of the picture in one of it. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, 1.5, 4})
  void meansAreThoseOfManyRays(double times) {
    Prepared scene = scene(FLOOR, times, Vector3d.ZERO);
    Probe probe = probe(scene);
    CornerGrid corners = corners(probe);
    Inlay inlay = new Inlay(corners, SCALE, scene, 0.1);
    double squares = 0;
    double claimed = 0;
    int count = 0;
    for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
      int x = pixel % SIZE;
      int y = pixel / SIZE;
      if (isSmooth(corners, x, y) && inlay.suits(x, y)) {
        inlay.look(x, y, 1);
        double[] truth = traced(probe, x, y);
        for (int i = 0; i < 3; i++) {
          squares += SCALE.squaredDifference(inlay.mean[i], truth[i]) / 3;
        }
        claimed += inlay.variance;
        count++;
      }
    }
    double error = Math.sqrt(squares / count);
    double claim = Math.sqrt(claimed / count);
    assertTrue(count > SIZE * SIZE / 3, count + " pixels");
    assertTrue(error < 1, error + " levels, claimed " + claim);
    assertTrue(error < 1.2 * claim + 0.02, error + " levels, claimed " + claim);
  }

  @Test
  void placesAreWhatRaysFindThere() {
    Prepared scene = scene(FLOOR, 1, Vector3d.ZERO);
    Probe probe = probe(scene);
    CornerGrid corners = corners(probe);
    Inlay inlay = new Inlay(corners, SCALE, scene, 1);
    assertTrue(isSmooth(corners, 9, 14) && inlay.suits(9, 14));
    for (double place : new double[] {0, 0.25, 0.6, 1}) {
      double near = place % 1 == 0 ? 1e-12 : 0.01;
      double[] found = inlay.at(place, 1 - place);
      probe.trace(9 + place, 15 - place);
      assertEquals(probe.r(), found[0], near);
      assertEquals(probe.g(), found[1], near);
      assertEquals(probe.b(), found[2], near);
    }
  }

  /** Around a sphere the image ends where it begins, in the middle of what is seen of it. */
  @Test
  void anImageThatLeapsIsNotFound() {
    Sphere sphere = new Sphere(new Vector3d(0, -1.5, -5), 1.3);
    Prepared scene = scene(sphere, 0.5, new Vector3d(0.5, 0, -12));
    CornerGrid corners = corners(probe(scene));
    Inlay inlay = new Inlay(corners, SCALE, scene, 1);
    int found = 0;
    int leaps = 0;
    for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
      int x = pixel % SIZE;
      int y = pixel / SIZE;
      int a = Prints.NUMBERS * (y * corners.stride + x);
      double[] seen = corners.prints.seen;
      if (Math.abs(seen[a] - seen[a + Prints.NUMBERS]) > 8) {
        leaps++;
        assertFalse(inlay.suits(x, y));
      } else if (isSmooth(corners, x, y) && inlay.suits(x, y)) {
        found++;
      }
    }
    assertTrue(found > 10, found + " found");
    assertTrue(leaps > 2, leaps + " leaps");
  }
}

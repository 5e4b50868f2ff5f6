package glint.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.BadValueException;
import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

class TurntableTest {

  private static final Vector3d Y = new Vector3d(0, 1, 0);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Camera camera() {
    return new Camera(v(1, 2, 8), v(1, 1, 3), v(0, 1, 0.5), new Perspective(40, false, 0), 1, 99);
  }

  private static Scene scene(Turntable table) {
    return new Scene.Builder("top").camera(camera()).turntable(table).build();
  }

  @Test
  void framesAreEvenlySpacedTurns() {
    for (double degrees : new double[] {360, -360, 45, 90, -100, 1000, 0, 1e-7}) {
      for (int frames : new int[] {1, 2, 7, 36}) {
        Turntable table = new Turntable(frames, v(1, -2, 0.5), degrees, Optional.empty());
        for (int i = 1; i <= frames; i++) {
          Quaternion truth = Quaternion.aboutAxis(table.axis(), degrees * (i - 1) / frames);
          Quaternion q = table.turn(i);
          double off = 0;
          for (Vector3d axis : List.of(v(1, 0, 0), Y, v(0, 0, 1))) {
            Vector3d there = Transform.rotate(truth).direction(axis);
            off = Math.max(off, Transform.rotate(q).direction(axis).minus(there).length());
          }
          // The angle itself, up to 9 in radians, is rounded, and by sine and cosine again.
          assertEquals(0, off, 64 * Rounding.U, degrees + " in " + frames + ", frame " + i);
        }
      }
    }
  }

  @Test
  void theCameraGoesRoundWhatItLooksAtOrAPoint() {
    List<Scene> four = scene(new Turntable(4, Y, 360, Optional.empty())).frames();
    assertEquals(
        List.of("top.0001", "top.0002", "top.0003", "top.0004"),
        four.stream().map(Scene::name).toList());
    assertSame(camera().projection().getClass(), four.get(1).camera().projection().getClass());
    assertEquals(camera(), four.get(0).camera());
    // Counter-clockwise from above: from the front to the right.
    assertNear(v(6, 2, 3), four.get(1).camera().position());
    assertNear(v(1, 1, 3), four.get(1).camera().lookAt());
    assertNear(v(0.5, 1, 0), four.get(1).camera().up());
    assertNear(v(1, 2, -2), four.get(2).camera().position());
    assertEquals(99, four.get(3).camera().far());

    Scene half = scene(new Turntable(2, Y, -180, Optional.of(v(0, 7, 0)))).frames().get(1);
    assertNear(v(-8, 2, 1), half.camera().position());
    assertNear(v(-3, 1, 1), half.camera().lookAt());
  }

  private static void assertNear(Vector3d expected, Vector3d actual) {
    assertEquals(0, expected.minus(actual).length(), 1e-14, actual + " is not " + expected);
  }

  @Test
  void aFrameIsAPictureOfItsOwn() {
    Scene one = new Scene.Builder("still").camera(camera()).build();
    assertEquals(List.of(one), one.frames());
    Scene frame = scene(new Turntable(3, Y, 360, Optional.empty())).frames().get(2);
    assertEquals(List.of(frame), frame.frames());
    assertTrue(frame.expectations().isEmpty());
  }

  @Test
  void aNameThatFramesMakeTooLongIsRefused() {
    Scene.Builder scene =
        new Scene.Builder("n".repeat(96))
            .camera(camera())
            .turntable(new Turntable(2, Y, 360, Optional.empty()));
    assertEquals("name", assertThrows(BadValueException.class, scene::build).field());
  }

  /** The eye goes into a glass ball and out of it again, and the world is built but once. */
  @Test
  void framesShareTheirWorld() {
    Medium glass = new Medium(1.5, Rgb.BLACK, 0);
    Material clear =
        new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK, Rgb.WHITE, glass);
    Scene.Builder scene =
        new Scene.Builder("top")
            .size(16, 12)
            .camera(camera())
            .background(new Background(Rgb.BLACK, Rgb.WHITE))
            .turntable(new Turntable(4, Y, 360, Optional.empty()))
            .place(Placement.of(new Sphere(v(6, 2, 3), 1), clear));
    for (int i = 0; i < 12; i++) {
      scene.place(Placement.of(new Sphere(v(i, -2, 0), 1), Material.WHITE));
    }
    List<Scene> frames = scene.build().frames();
    Prepared first = Prepared.of(frames.get(0));
    assertEquals(0, first.mediaAtEye().length);
    for (int i = 1; i < 4; i++) {
      Prepared shared = first.seenIn(frames.get(i));
      Prepared own = Prepared.of(frames.get(i));
      assertEquals(i == 1 ? 1 : 0, shared.mediaAtEye().length);
      assertSame(first.primitives(), shared.primitives());
      assertArrayEquals(pixels(own), pixels(shared));
    }
    Scene other = scene.light(new Light.Ambient(Rgb.WHITE)).build();
    assertThrows(IllegalArgumentException.class, () -> first.seenIn(other));
  }

  private static double[] pixels(Prepared scene) {
    RenderSettings settings =
        new RenderSettings(16, 12, 1, 0, OptionalInt.empty(), 1, 32, Set.of());
    return new Renderer(scene, settings).render(Progress.NONE).image().rgb();
  }
}

package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Lens;
import glint.scene.Orthographic;
import glint.scene.Perspective;
import glint.scene.Projection;
import glint.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class CameraTextTest {

  @Provide
  Arbitrary<Camera> cameras() {
    Arbitrary<Double> numbers =
        Arbitraries.oneOf(
            Arbitraries.doubles().between(-1e100, 1e100),
            Arbitraries.doubles().between(-9, 9).ofScale(17),
            Arbitraries.of(0.0, -0.0, 1.0, 0.1, 1e-300, Double.MIN_VALUE, -1e100));
    Arbitrary<Double> lengths = Arbitraries.of(1e-100, 1e100, 1 / 3.0, 7.0);
    Arbitrary<Vector3d> points = Combinators.combine(numbers, numbers, numbers).as(Vector3d::new);
    Arbitrary<Double> degrees = Arbitraries.of(Double.MIN_VALUE, 40.0, 100 / 3.0, 179.99999999);
    Arbitrary<Double> aspects = Arbitraries.of(0.0, 1.5, 1 / 3.0);
    Arbitrary<Projection> projections =
        Arbitraries.oneOf(
            Combinators.combine(degrees, Arbitraries.of(true, false), aspects).as(Perspective::new),
            lengths.map(Orthographic::new));
    Arbitrary<Optional<Lens>> lenses =
        Combinators.combine(lengths, lengths).as(Lens::new).optional();
    return Combinators.combine(points, points, projections, lenses, lengths)
        .as(
            (eye, away, projection, lens, far) ->
                new Camera(
                    eye, aside(eye, away), new Vector3d(0.1, 7, -1e-9), projection, 0, far, lens));
  }

  /** Returns a point beside another, level with it. */
  private static Vector3d aside(Vector3d eye, Vector3d away) {
    return new Vector3d(-0.5 * eye.x() - 1, eye.y(), away.z());
  }

  private static Camera read(Camera camera) {
    String text = "scenes:\n  a:\n    " + CameraText.of(camera) + "\n    surfaces: []\n";
    SceneFile file = Resources.read(text, "a.yaml");
    assertEquals(1, file.scenes().size(), () -> file.problems() + " in " + text);
    return file.scenes().get(0).camera();
  }

  @Property(tries = 300)
  void whatIsWrittenIsReadAsTheSame(@ForAll("cameras") Camera camera) {
    assertEquals(camera, read(camera));
  }

  @Test
  void allOfTheGalleryIs() throws IOException {
    for (Path file : Resources.scenes(".yaml")) {
      for (Scene scene : Resources.read(file).scenes()) {
        assertEquals(scene.camera(), read(scene.camera()));
      }
    }
  }

  @Test
  void itReadsWell() {
    Camera camera =
        new Camera(
            new Vector3d(1.25, -2, 1e9),
            Vector3d.ZERO,
            new Vector3d(0, 1, -0.0),
            new Perspective(40, true, 0),
            0.5,
            100,
            Optional.of(new Lens(0.25, 8)));
    assertEquals(
        "camera: {position: [1.25, -2, 1.0E9], look_at: [0, 0, 0], up: [0, 1, -0.0],"
            + " fov: {horizontal: 40}, near: 0.5, far: 100, lens: {radius: 0.25, focus: 8}}",
        CameraText.of(camera));
  }
}

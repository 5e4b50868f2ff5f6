package glint.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Material;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The extra picture of what surfaces are coloured like. */
class AlbedoTest {

  @Test
  void theAlbedoShowsTheTexture() {
    Rgb diffuse = new Rgb(0.5, 1, 0.25);
    Material material =
        new Material(Rgb.BLACK, diffuse, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK)
            .textured(new Checker(1, Rgb.WHITE, new Rgb(0.5, 0.25, 0)));
    Vector3d up = new Vector3d(0, 1, 0);
    Vector3d eye = new Vector3d(0, 0, 3);
    Scene scene =
        new Scene.Builder("albedo")
            .size(2, 1)
            .camera(Camera.of(eye, new Vector3d(0, 0, 0), up, new Orthographic(1)))
            .place(Placement.of(new Plane(Vector3d.ZERO, eye), material))
            .build();
    RenderSettings settings =
        new RenderSettings(2, 1, 1, 0, OptionalInt.empty(), 1, 32, Set.of(Aov.ALBEDO));
    RenderResult result = new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
    // Both centres lie at y = 0: x = -1/2 is in the cell of the other colour.
    double[] expected = {0.25, 0.25, 0, 0.5, 1, 0.25};
    double[] actual = result.aovs().get(Aov.ALBEDO).rgb();
    assertArrayEquals(expected, actual, () -> Arrays.toString(actual));
  }
}

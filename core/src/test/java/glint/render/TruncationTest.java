package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.image.Image;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What is cut off is never more than what is reported. */
class TruncationTest {

  private static Scene scene(Material ball, Material floor) {
    return new Scene.Builder("cut")
        .camera(
            Camera.of(
                new Vector3d(0, 1, 6),
                new Vector3d(0, 0.5, 0),
                new Vector3d(0, 1, 0),
                Projection.vertical(30)))
        .background(new Background(Rgb.grey(0.2), Rgb.WHITE))
        .place(Placement.of(new Sphere(new Vector3d(0, 1, 0), 1), ball))
        .place(Placement.of(new Plane(Vector3d.ZERO, new Vector3d(0, 1, 0)), floor))
        .build();
  }

  private static RenderResult render(Scene scene, OptionalInt depth) {
    RenderSettings settings = new RenderSettings(48, 36, 2, 0, depth, 2, 16, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** The RMS distance of two images in display levels. */
  private static double distance(Image a, Image b) {
    double sum = 0;
    for (int i = 0; i < a.rgb().length; i++) {
      double d = Transfer.SRGB.level(a.rgb()[i]) - Transfer.SRGB.level(b.rgb()[i]);
      sum += d * d;
    }
    return Math.sqrt(sum / a.rgb().length);
  }

  @Test
  void whatIsMissingIsWithinTheReportedBoundForEveryDepth() {
    Material glass =
        new Material(
            Rgb.BLACK,
            Rgb.BLACK,
            Rgb.BLACK,
            1,
            Rgb.BLACK,
            Rgb.BLACK,
            Rgb.WHITE,
            new Medium(1.5, Rgb.BLACK, 0));
    Material mirror =
        new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.grey(0.8), Rgb.grey(0.1));
    Scene scene = scene(glass, mirror);
    Image exact = render(scene, OptionalInt.of(60)).image();
    double before = Double.POSITIVE_INFINITY;
    for (int depth = 0; depth <= 12; depth++) {
      RenderResult result = render(scene, OptionalInt.of(depth));
      double reported = result.statistics().truncation();
      double missing = distance(exact, result.image());
      assertTrue(missing <= reported * (1 + 1e-9) + 1e-9, missing + " of at most " + reported);
      assertTrue(reported <= before, "a deeper render reports more");
      before = reported;
    }
    // Without a stated depth, what is lost does not show.
    RenderResult plain = render(scene, OptionalInt.empty());
    assertTrue(
        plain.statistics().truncation() < 0.05, "at most " + plain.statistics().truncation());
    assertTrue(distance(exact, plain.image()) <= plain.statistics().truncation());
  }

  @Test
  void aSurfaceThatMirrorsAndRefractsInFullEndsAllTheSame() {
    Material impossible =
        new Material(
            Rgb.BLACK,
            Rgb.BLACK,
            Rgb.BLACK,
            1,
            Rgb.WHITE,
            Rgb.BLACK,
            Rgb.WHITE,
            new Medium(1.5, Rgb.BLACK, 0));
    RenderResult result = render(scene(impossible, impossible), OptionalInt.empty());
    assertEquals(0, result.statistics().invalid());
  }

  @Test
  void perfectMirrorsAreBoundedByTheDisplay() {
    Material perfect = new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.WHITE, Rgb.grey(0.5));
    double reported = render(scene(perfect, perfect), OptionalInt.of(0)).statistics().truncation();
    assertTrue(reported > 10 && reported <= 255, "reported " + reported);
    Scene matt = scene(Material.WHITE, Material.WHITE);
    assertEquals(0, render(matt, OptionalInt.empty()).statistics().truncation());
  }
}

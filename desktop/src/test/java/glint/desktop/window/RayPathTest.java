package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.awt.Point;
import java.awt.geom.Point2D;
import java.util.List;
import org.junit.jupiter.api.Test;

class RayPathTest {

  private static final Material MIRROR =
      new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.grey(0.9), Rgb.BLACK);

  /** From the origin along -z, with a right angle of view: a pixel is a hundredth of the depth. */
  private static Scene.Builder scene() {
    Vector3d ahead = new Vector3d(0, 0, -1);
    Vector3d up = new Vector3d(0, 1, 0);
    return new Scene.Builder("a")
        .size(200, 200)
        .background(Background.constant(Rgb.WHITE))
        .light(new Light.Ambient(Rgb.WHITE))
        .camera(Camera.of(Vector3d.ZERO, ahead, up, Projection.vertical(90)));
  }

  private static Placement plane(double x, double y, double z, Vector3d normal, Material material) {
    return Placement.of(new Plane(new Vector3d(x, y, z), normal), material);
  }

  private static List<RayPath.Leg> legs(Scene scene, int column, int row) {
    Prepared prepared = Prepared.of(scene);
    RenderSettings one = RenderSettings.of(scene).sampled(1, 0);
    Replay.Sample sample = new Replay(prepared, one, column, row).sample(0);
    return RayPath.legs(new PixelRays(prepared, new Point(column, row), sample));
  }

  private static void assertAt(double column, double row, Point2D place) {
    assertEquals(column, place.getX(), 1e-6);
    assertEquals(row, place.getY(), 1e-6);
  }

  /** Down on a mirror at y = -1, from there up to a wall at z = -10. */
  @Test
  void aReflectionLeadsFromThePixelToWhereItsEndIsSeen() {
    Vector3d up = new Vector3d(0, 1, 0);
    Vector3d back = new Vector3d(0, 0, 1);
    Scene scene =
        scene()
            .place(plane(0, -1, 0, up, MIRROR))
            .place(plane(0, 0, -10, back, Material.WHITE))
            .build();
    List<RayPath.Leg> legs = legs(scene, 99, 119);
    assertEquals(1, legs.size());
    assertTrue(legs.get(0).ends());
    assertAt(99.5, 119.5, legs.get(0).way().getP1());
    // The slope is 0.195: at z = -10, and y = -1 mirrored, the ray is at y = 1.95 - 2 = -0.05.
    assertAt(99.5, 100.5, legs.get(0).way().getP2());
  }

  @Test
  void whatLeavesIsDrawnFarOnAndWhatComesBackOnlyInFrontOfTheEye() {
    Vector3d back = new Vector3d(0, 0, 1);
    Scene.Builder scene = scene().place(plane(0, 0, -5, back, MIRROR));
    RayPath.Leg leg = legs(scene.build(), 119, 99).get(0);
    assertFalse(leg.ends());
    assertAt(119.5, 99.5, leg.way().getP1());
    scene.place(plane(0, 0, 20, back.negated(), Material.WHITE));
    RayPath.Leg wall = legs(scene.build(), 119, 99).get(0);
    assertFalse(wall.ends());
    // Straight back and to the side: at a depth of 0.005 nearly two units to the right of the axis.
    assertAt(100 + 100 * 0.195 * (10 - 0.005) / 0.005, 99.5, between(wall));
  }

  /** Returns the end, moved to the row of the begin. */
  private static Point2D between(RayPath.Leg leg) {
    return new Point2D.Double(leg.way().getX2(), leg.way().getY1());
  }
}

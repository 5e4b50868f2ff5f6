package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import org.junit.jupiter.api.Test;

class CutoffTest {

  /** Two mirrors that face each other; the camera stands between them. */
  private static double between(double reflection) {
    Material mirror =
        new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.grey(reflection), Rgb.BLACK);
    Vector3d ahead = new Vector3d(0, 0, 1);
    Scene scene =
        new Scene.Builder("mirrors")
            .size(8, 6)
            .camera(Camera.of(Vector3d.ZERO, ahead, new Vector3d(0, 1, 0), Projection.vertical(40)))
            .background(new Background(Rgb.WHITE, Rgb.WHITE))
            .place(Placement.of(new Plane(ahead.times(2), ahead.times(-1)), mirror))
            .place(Placement.of(new Plane(ahead.times(-2), ahead), mirror))
            .build();
    LevelScale scale = LevelScale.of(scene.transfer());
    return Cutoff.find(Prepared.of(scene), RenderSettings.of(scene), 1, scale);
  }

  /** What is cut off is 2^-16 of white at an eighth, too much by 0.0003 levels, and 2^-17 here. */
  @Test
  void bouncesAreFollowedUntilNoMoreIsLostThanTheirShare() {
    assertEquals(0.05 / 255 / 16, between(0.5));
  }

  /** After 64 bounces all light is left, and lost whatever the cut-off is. */
  @Test
  void whatIsLostAtTheLimitOfBouncesIsNotSoughtFor() {
    assertEquals(0.05 / 255 / 2, between(1));
  }
}

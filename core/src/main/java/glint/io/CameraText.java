package glint.io;

import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Perspective;
import glint.scene.Projection;

/** Writes cameras as scene files have them. */
public final class CameraText {

  private CameraText() {}

  /** Returns a line of YAML, {@code camera: {…}}, that is read as exactly this camera. */
  public static String of(Camera camera) {
    StringBuilder text = new StringBuilder("camera: {position: ").append(vector(camera.position()));
    text.append(", look_at: ").append(vector(camera.lookAt()));
    text.append(", up: ").append(vector(camera.up()));
    text.append(projection(camera.projection()));
    if (camera.near() != 0) {
      text.append(", near: ").append(number(camera.near()));
    }
    if (camera.far() < Double.POSITIVE_INFINITY) {
      text.append(", far: ").append(number(camera.far()));
    }
    camera
        .lens()
        .ifPresent(
            lens -> {
              text.append(", lens: {radius: ").append(number(lens.radius()));
              text.append(", focus: ").append(number(lens.focus())).append('}');
            });
    return text.append('}').toString();
  }

  private static String projection(Projection projection) {
    if (projection instanceof Orthographic parallel) {
      return ", orthographic: " + number(parallel.planeHeight());
    }
    Perspective p = (Perspective) projection;
    String degrees = number(p.degrees());
    if (!p.horizontal() && p.aspect() == 0) {
      return ", fov: " + degrees;
    }
    String aspect = p.aspect() == 0 ? "" : ", aspect: " + number(p.aspect());
    return ", fov: {" + (p.horizontal() ? "horizontal: " : "vertical: ") + degrees + aspect + "}";
  }

  private static String vector(Vector3d v) {
    return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]";
  }

  /** Returns a number with as many digits as it needs; whole ones, but for -0, without a point. */
  private static String number(double x) {
    String text = Double.toString(x);
    boolean whole = text.endsWith(".0") && x != 0;
    return whole || text.equals("0.0") ? text.substring(0, text.length() - 2) : text;
  }
}

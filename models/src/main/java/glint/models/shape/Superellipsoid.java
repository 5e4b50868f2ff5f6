package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/**
 * Balls that lean towards boxes (A. Barr, Superquadrics and Angle-Preserving Transformations,
 * 1981).
 */
public final class Superellipsoid {

  private Superellipsoid() {}

  /**
   * Returns the body around the origin that fits into a box.
   *
   * @param radii half the extent of the box
   * @param roundness 1 for an ellipsoid; towards 0 it fills the box
   */
  public static Shape of(Vector3d radii, double roundness, int segments, int rings) {
    List<List<Vector3d>> rows = new ArrayList<>();
    for (int row = 1; row < rings; row++) {
      double latitude = Math.PI * row / rings - Math.PI / 2;
      double width = power(StrictMath.cos(latitude), roundness);
      double y = power(StrictMath.sin(latitude), roundness) * radii.y();
      List<Vector3d> ring = new ArrayList<>();
      for (int i = 0; i < segments; i++) {
        double angle = 2 * Math.PI * (i + 0.5) / segments;
        double x = width * power(StrictMath.sin(angle), roundness) * radii.x();
        ring.add(new Vector3d(x, y, width * power(StrictMath.cos(angle), roundness) * radii.z()));
      }
      rows.add(ring);
    }
    return Loft.body(new Vector3d(0, -radii.y(), 0), rows, new Vector3d(0, radii.y(), 0));
  }

  private static double power(double base, double exponent) {
    return Math.signum(base) * StrictMath.pow(Math.abs(base), exponent);
  }
}

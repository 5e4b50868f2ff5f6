package glint.render;

import glint.math.Vector3d;
import glint.scene.View;
import java.util.List;

/** The outline of some points in the image: their convex hull, projected; scratch. */
final class Silhouette {

  /** What lies nearer to the eye than this share of the whole is cut off. */
  private static final double NEAR = 0x1p-20;

  private final View view;
  private final double[] point = new double[3];

  /** The outline found last, for the caller to close. */
  final ConvexPolygon whole = new ConvexPolygon();

  Silhouette(View view) {
    this.view = view;
  }

  /** Projects points in the world. */
  void project(List<Vector3d> points) {
    double[] places = new double[3 * points.size()];
    int at = 0;
    for (Vector3d p : points) {
      places[at++] = p.x();
      places[at++] = p.y();
      places[at++] = p.z();
    }
    project(places);
  }

  /**
   * Projects points in the world.
   *
   * @param places three numbers a point
   */
  void project(double[] places) {
    double farthest = 0;
    for (int i = 0; i < places.length; i += 3) {
      farthest = Math.max(farthest, depth(places, i));
    }
    double least = NEAR * farthest;
    whole.clear();
    for (int i = 0; i < places.length; i += 3) {
      double depth = depth(places, i);
      if (depth >= least) {
        add(places[i], places[i + 1], places[i + 2]);
      }
      for (int j = 0; depth < least && j < places.length; j += 3) {
        double other = depth(places, j);
        if (other > least) {
          double s = (least - depth) / (other - depth);
          add(
              places[i] + s * (places[j] - places[i]),
              places[i + 1] + s * (places[j + 1] - places[i + 1]),
              places[i + 2] + s * (places[j + 2] - places[i + 2]));
        }
      }
    }
  }

  private double depth(double[] places, int i) {
    return view.depth(places[i], places[i + 1], places[i + 2]);
  }

  private void add(double x, double y, double z) {
    view.project(x, y, z, point);
    whole.add(point[0], point[1]);
  }
}

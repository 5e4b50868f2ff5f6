package glint.optics;

import glint.math.Vector3d;

/**
 * An image on each face of a box, upright as seen from outside; immutable. Above and below it is
 * seen as if from the front, which is z.
 */
public record Faces(Vector3d min, Vector3d max) implements Mapping {

  @Override
  public void find(double px, double py, double pz, int flat, Texel texel) {
    double x = (px - min.x()) / (max.x() - min.x());
    double y = (py - min.y()) / (max.y() - min.y());
    double z = (pz - min.z()) / (max.z() - min.z());
    switch (flat) {
      case 0 -> {
        texel.u = x > 0.5 ? 1 - z : z;
        texel.v = y;
      }
      case 1 -> {
        texel.u = x;
        texel.v = y > 0.5 ? 1 - z : z;
      }
      default -> {
        texel.u = z > 0.5 ? x : 1 - x;
        texel.v = y;
      }
    }
  }
}

package glint.geometry;

/**
 * Tells cheaply, without a division, that a ray misses a cylinder, cone or frustum; see
 * CylinderKernel for its numbers.
 */
final class CylinderMiss {

  /**
   * What the square of a distance may be off by, as a share of the squares that it comes from.
   *
   * <p>The kernel decides as if the surface were moved by at most 36uS, S = |f| + size; that adds
   * 72u·S·ρ|d|² at most to (ρ|d⊥|)², and rounding here 16u|f|²|d|². Both together are less than
   * 2⁻⁴⁴(|f|² + height² + radius²)|d|².
   */
  private static final double MARGIN = 0x1p-40;

  private CylinderMiss() {}

  /**
   * Returns whether it is certain that nothing is hit: the ray begins beyond one end or outside of
   * the side, and leads away from it, or its whole line passes by farther off than the widest
   * radius.
   */
  static boolean isCertain(double[] data, int at, Ray ray) {
    double fx = ray.ox - data[at];
    double fy = ray.oy - data[at + 1];
    double fz = ray.oz - data[at + 2];
    double ax = data[at + 3];
    double ay = data[at + 4];
    double az = data[at + 5];
    double height = data[at + 6];
    double radius = data[at + 7];
    double slope = data[at + 8];
    double fs = fx * ax + fy * ay + fz * az;
    double ds = ray.dx * ax + ray.dy * ay + ray.dz * az;
    if ((fs > height && ds >= 0) || (fs < 0 && ds <= 0)) {
      return true;
    }
    fx -= fs * ax;
    fy -= fs * ay;
    fz -= fs * az;
    double dx = ray.dx - ds * ax;
    double dy = ray.dy - ds * ay;
    double dz = ray.dz - ds * az;
    double off = fx * fx + fy * fy + fz * fz;
    double across = dx * dx + dy * dy + dz * dz;
    double along = fx * dx + fy * dy + fz * dz;
    double rho = radius + slope * fs;
    double widening = slope * ds;
    // |p⊥|² - ρ² is above zero and grows for ever.
    if (off > rho * rho && along > widening * rho && across >= widening * widening) {
      return true;
    }
    double widest = Math.max(radius, radius + slope * height);
    double length2 = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
    double size2 = off + fs * fs + height * height + widest * widest;
    return off * across - along * along > widest * widest * across + MARGIN * size2 * length2;
  }
}

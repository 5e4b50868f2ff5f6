package glint.light;

import glint.geometry.Hit;
import glint.geometry.Quad;
import glint.geometry.Surface;
import glint.math.Vector3d;
import glint.sampling.Bilinear;
import glint.sampling.SobolSampler;

/**
 * A rectangle that shines on one side; immutable.
 *
 * <p>Seen from nearby, directions are even over its solid angle (C. Ureña, M. Fajardo and A. King,
 * An Area-Preserving Parametrization for Spherical Rectangles, Computer Graphics Forum 32(4),
 * 2013); from afar, where digits of that angle cancel, points are even over its area. Either way
 * they are as dense as what they bring, as its corners tell.
 */
final class PanelLamp implements Lamp {

  /** From so many times its diagonal, the lamp is far. */
  private static final double FAR = 8;

  /** No corner weighs less than this share of the heaviest. */
  private static final double LEAST = 0.25;

  private final Quad quad;
  private final Vector3d middle;
  private final Vector3d right;
  private final Vector3d up;
  private final Vector3d front;
  private final double halfWidth;
  private final double halfHeight;
  private final double farSquared;

  PanelLamp(Vector3d corner, Vector3d edge1, Vector3d edge2) {
    quad = new Quad(corner, edge1, edge2);
    middle = corner.plus(edge1.plus(edge2).times(0.5));
    right = edge1.normalized();
    front = right.cross(edge2.normalized()).normalized();
    up = front.cross(right);
    halfWidth = edge1.length() / 2;
    halfHeight = edge2.length() / 2;
    farSquared = 4 * FAR * FAR * (halfWidth * halfWidth + halfHeight * halfHeight);
  }

  @Override
  public double sample(Hit hit, SobolSampler numbers, LightSample out) {
    double dx = middle.x() - hit.px;
    double dy = middle.y() - hit.py;
    double dz = middle.z() - hit.pz;
    double h = -(dx * front.x() + dy * front.y() + dz * front.z());
    if (!(h > 0)) {
      return 0;
    }
    double x = dx * right.x() + dy * right.y() + dz * right.z();
    double y = dx * up.x() + dy * up.y() + dz * up.z();
    double squared = dx * dx + dy * dy + dz * dz;
    boolean far = squared > farSquared;
    if (numbers.isCentred()) {
      double d = Math.sqrt(squared);
      out.lead(dx / d, dy / d, dz / d);
      out.place(middle.x(), middle.y(), middle.z());
      return (far ? area() * h / (squared * d) : solidAngle(x, y, h)) / Math.PI;
    }
    if (!warp(hit, x, y, h, far, numbers, out)) {
      return 0;
    }
    Bilinear warp = out.warp;
    double worth;
    if (far) {
      // Points are even over the area.
      out.lx = x + (2 * warp.u - 1) * halfWidth;
      out.ly = y + (2 * warp.v - 1) * halfHeight;
      double toPoint = Math.sqrt(out.lx * out.lx + out.ly * out.ly + h * h);
      worth = area() * h / (toPoint * toPoint * toPoint);
    } else {
      worth = spread(x, y, h, out);
    }
    lead(x, y, h, out);
    return worth / (Math.PI * warp.density);
  }

  /** Turns the point of the plane in {@code lx} and {@code ly}, as seen, into a place. */
  private void lead(double x, double y, double h, LightSample out) {
    double px = out.lx;
    double py = out.ly;
    double d = Math.sqrt(px * px + py * py + h * h);
    out.lead(
        (px * right.x() + py * up.x() - h * front.x()) / d,
        (px * right.y() + py * up.y() - h * front.y()) / d,
        (px * right.z() + py * up.z() - h * front.z()) / d);
    double a = px - x;
    double b = py - y;
    out.place(
        middle.x() + a * right.x() + b * up.x(),
        middle.y() + a * right.y() + b * up.y(),
        middle.z() + a * right.z() + b * up.z());
  }

  /**
   * Chooses two numbers as dense as what the lamp brings there.
   *
   * @param x where the middle of the lamp is, along its edges, and {@code h} before it
   * @return whether any corner is above the surface
   */
  private boolean warp(
      Hit hit, double x, double y, double h, boolean far, SobolSampler numbers, LightSample out) {
    double alongX = hit.sx * right.x() + hit.sy * right.y() + hit.sz * right.z();
    double alongY = hit.sx * up.x() + hit.sy * up.y() + hit.sz * up.z();
    double base = -h * (hit.sx * front.x() + hit.sy * front.y() + hit.sz * front.z());
    double w00 = weight(alongX, alongY, base, x - halfWidth, y - halfHeight, h, far);
    double w10 = weight(alongX, alongY, base, x + halfWidth, y - halfHeight, h, far);
    double w01 = weight(alongX, alongY, base, x - halfWidth, y + halfHeight, h, far);
    double w11 = weight(alongX, alongY, base, x + halfWidth, y + halfHeight, h, far);
    double most = Math.max(Math.max(w00, w10), Math.max(w01, w11));
    double least = LEAST * most;
    if (!(least > 0)) {
      return false;
    }
    out.warp.at(
        numbers.u,
        numbers.v,
        Math.max(w00, least),
        Math.max(w10, least),
        Math.max(w01, least),
        Math.max(w11, least));
    return true;
  }

  /** Returns the cosine at which a corner is seen, or what a part of the area there brings. */
  private static double weight(
      double alongX, double alongY, double base, double x, double y, double h, boolean far) {
    double squared = x * x + y * y + h * h;
    double d = Math.sqrt(squared);
    double cos = (alongX * x + alongY * y + base) / d;
    return far ? cos * h / (squared * d) : cos;
  }

  /**
   * Chooses a point of the plane, into {@code lx} and {@code ly}, such that directions to it are
   * even over the solid angle.
   *
   * @return the solid angle
   */
  private double spread(double x, double y, double h, LightSample out) {
    double x0 = x - halfWidth;
    double x1 = x + halfWidth;
    double y0 = y - halfHeight;
    double y1 = y + halfHeight;
    double solid = solidAngle(x, y, h);
    double b0 = -y0 / Math.sqrt(y0 * y0 + h * h);
    double b1 = y1 / Math.sqrt(y1 * y1 + h * h);
    double angle =
        out.warp.u * solid
            + 2 * Math.PI
            - (corner(x0, y1, h, x0 * y1) + corner(x0, y0, h, -x0 * y0));
    double f = (StrictMath.cos(angle) * b0 - b1) / StrictMath.sin(angle);
    double cos = Math.copySign(1 / Math.sqrt(f * f + b0 * b0), f);
    double px = clamp(cos * h / Math.sqrt((1 - cos) * (1 + cos)), x0, x1);
    double d = px * px + h * h;
    double s0 = y0 / Math.sqrt(d + y0 * y0);
    double s1 = y1 / Math.sqrt(d + y1 * y1);
    double sin = s0 + out.warp.v * (s1 - s0);
    out.lx = px;
    out.ly = clamp(sin * Math.sqrt(d / ((1 - sin) * (1 + sin))), y0, y1);
    return solid;
  }

  /** Returns the number in the range; what is none, where digits are lost, becomes the least. */
  private static double clamp(double number, double least, double most) {
    return number > least ? Math.min(number, most) : least;
  }

  /**
   * Returns the solid angle of the lamp: what the angles of its image on the sphere exceed 2π by.
   */
  private double solidAngle(double x, double y, double h) {
    double x0 = x - halfWidth;
    double x1 = x + halfWidth;
    double y0 = y - halfHeight;
    double y1 = y + halfHeight;
    double some = corner(x1, y0, h, x1 * y0) + corner(x0, y1, h, x0 * y1);
    double others = corner(x1, y1, h, -x1 * y1) + corner(x0, y0, h, -x0 * y0);
    return Math.max(0, some + others - 2 * Math.PI);
  }

  /** Returns the angle between two sides of the image at a corner. */
  private static double corner(double x, double y, double h, double product) {
    return StrictMath.atan2(h * Math.sqrt(x * x + y * y + h * h), product);
  }

  private double area() {
    return 4 * halfWidth * halfHeight;
  }

  @Override
  public Surface shape() {
    return quad;
  }
}

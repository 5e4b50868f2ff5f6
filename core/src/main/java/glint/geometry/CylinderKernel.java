package glint.geometry;

import glint.math.Vector3d;

/**
 * Ray against cylinder, cone or frustum: base, unit axis, height, radius, slope, capped.
 *
 * <p>The side is |p⊥| = ρ(s), ρ(s) = radius + slope·s, with s along and p⊥ across the axis. As for
 * the sphere, the discriminant comes from l, the point of the ray nearest to the axis, seen across
 * it: D = a(ρ₀² - l²) + (slope·ds)²l² with ρ₀ = ρ at l, not from b² - ac. A capped one is convex:
 * the part of the ray inside is the part inside the side cut by the part between the caps, so no
 * ray slips through at a rim.
 */
final class CylinderKernel {

  /** How many doubles a cylinder takes. */
  static final int SIZE = 10;

  /** What is farther off the axis than this share of the widest radius beyond it is no hit. */
  private static final double MARGIN = 0x1p-42;

  private static final int SIDE = 0;
  private static final int BASE = 1;
  private static final int TOP = 2;

  private CylinderKernel() {}

  static double[] pack(
      Vector3d base, Vector3d axis, double radius, double topRadius, boolean capped) {
    Vector3d a = axis.normalized();
    double height = axis.dot(a);
    double slope = (topRadius - radius) / height;
    double[] data = {
      base.x(), base.y(), base.z(), a.x(), a.y(), a.z(), height, radius, slope, capped ? 1 : 0
    };
    return data;
  }

  /** The box around two discs: one of radius r and unit normal a reaches r√(aⱼ² + aₖ²) along i. */
  static void bounds(double[] data, int at, double[] out) {
    double height = data[at + 6];
    double radius = data[at + 7];
    double topRadius = Math.abs(radius + data[at + 8] * height);
    for (int axis = 0; axis < 3; axis++) {
      double a = data[at + 3 + axis];
      double j = data[at + 3 + (axis + 1) % 3];
      double k = data[at + 3 + (axis + 2) % 3];
      double reach = Math.sqrt(j * j + k * k);
      double base = data[at + axis];
      double top = base + height * a;
      out[axis] = Math.min(base - radius * reach, top - topRadius * reach);
      out[3 + axis] = Math.max(base + radius * reach, top + topRadius * reach);
    }
  }

  static void intersect(double[] data, int at, Ray ray, Hit hit, int id) {
    if (CylinderMiss.isCertain(data, at, ray)) {
      return;
    }
    double fx = ray.ox - data[at];
    double fy = ray.oy - data[at + 1];
    double fz = ray.oz - data[at + 2];
    double ax = data[at + 3];
    double ay = data[at + 4];
    double az = data[at + 5];
    double height = data[at + 6];
    double slope = data[at + 8];

    // Begin at the point of the ray nearest to the middle of the axis: from there on all numbers
    // are as large as the cylinder, however far away the origin is.
    double radius = data[at + 7];
    double length2 = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
    double half = 0.5 * height;
    double start =
        -((fx - half * ax) * ray.dx + (fy - half * ay) * ray.dy + (fz - half * az) * ray.dz)
            / length2;
    fx += start * ray.dx;
    fy += start * ray.dy;
    fz += start * ray.dz;

    // Split point and direction into parts along and across the axis.
    double fs = fx * ax + fy * ay + fz * az;
    double ds = ray.dx * ax + ray.dy * ay + ray.dz * az;
    fx -= fs * ax;
    fy -= fs * ay;
    fz -= fs * az;
    double dx = ray.dx - ds * ax;
    double dy = ray.dy - ds * ay;
    double dz = ray.dz - ds * az;

    // Go on to the point nearest to the axis, but not beyond the cylinder's reach.
    double widening = slope * ds;
    double across = dx * dx + dy * dy + dz * dz;
    double reach = (height + radius + Math.abs(slope * height)) / Math.sqrt(length2);
    double nearest = across > 0 ? -(fx * dx + fy * dy + fz * dz) / across : 0;
    nearest = Math.min(Math.max(nearest, -reach), reach);
    double lx = fx + nearest * dx;
    double ly = fy + nearest * dy;
    double lz = fz + nearest * dz;
    fs += nearest * ds;
    start += nearest;
    double l2 = lx * lx + ly * ly + lz * lz;
    double rho = radius + slope * fs;

    // Compute the discriminant, qb² - qa qc, as |ρe - (slope ds)w|² - |w × e|²: no digits cancel
    // but at the silhouette. A ray steeper than the side always meets it.
    double gx = rho * dx - widening * lx;
    double gy = rho * dy - widening * ly;
    double gz = rho * dz - widening * lz;
    double hx = ly * dz - lz * dy;
    double hy = lz * dx - lx * dz;
    double hz = lx * dy - ly * dx;
    double discriminant = gx * gx + gy * gy + gz * gz - (hx * hx + hy * hy + hz * hz);
    double qa = across - widening * widening;
    if (discriminant < 0 && qa < 0) {
      discriminant = 0;
    }
    if (!(discriminant >= 0)) {
      return;
    }

    // Solve for the side from there.
    double qb = lx * dx + ly * dy + lz * dz - widening * rho;
    double qc = l2 - rho * rho;
    double root = Math.sqrt(discriminant);
    double q = qb > 0 ? -qb - root : -qb + root;
    double one = q / qa;
    // Where one root lies far beyond the cylinder, the other one would cancel.
    boolean cancels = Math.abs(q) > 4 * reach * Math.abs(qa);
    double other = cancels ? qc / q : (qb > 0 ? -qb + root : -qb - root) / qa;
    double near = Math.min(one, other);
    double far = Math.max(one, other);
    // A flat cone's roots know where along the axis they are, but hardly how far off it.
    double middle = 0;
    double limit = Double.POSITIVE_INFINITY;
    if (slope * slope > 1 && across > 0) {
      double widest = Math.max(radius, radius + slope * height);
      double along = lx * dx + ly * dy + lz * dz;
      middle = -along / across;
      double room = widest * widest * (1 + MARGIN) - (l2 + middle * along);
      if (room < 0) {
        return;
      }
      limit = Math.sqrt(room / across);
    }
    if (data[at + 9] == 0) {
      if (Math.abs(near - middle) <= limit) {
        offerSide(near, 1, start, fs, ds, height, ray, hit, id);
      }
      if (Math.abs(far - middle) <= limit) {
        offerSide(far, -1, start, fs, ds, height, ray, hit, id);
      }
      return;
    }
    if (qa == 0) { // parallel to a line of the side: inside up to one point, or from it on
      boolean never = qb == 0 && !(qc <= 0);
      near = never ? Double.POSITIVE_INFINITY : qb < 0 ? other : Double.NEGATIVE_INFINITY;
      far = qb > 0 ? other : Double.POSITIVE_INFINITY;
    } else if (qa < 0) { // steeper than the side: inside beyond one root, on the nappe that opens
      near = widening > 0 ? far : Double.NEGATIVE_INFINITY;
      far = widening > 0 ? Double.POSITIVE_INFINITY : Math.min(one, other);
    }
    near = Math.max(near, middle - limit);
    far = Math.min(far, middle + limit);
    offerSolid(near, far, start, fs, ds, height, ray, hit, id);
  }

  private static void offerSide(
      double t,
      int crossing,
      double start,
      double fs,
      double ds,
      double height,
      Ray ray,
      Hit hit,
      int id) {
    double s = fs + t * ds;
    if (s >= 0 && s <= height) {
      hit.offer(ray, start + t, id, crossing, SIDE, 0);
    }
  }

  /** Cuts the part of the ray inside the side by the part between the caps. */
  private static void offerSolid(
      double near,
      double far,
      double start,
      double fs,
      double ds,
      double height,
      Ray ray,
      Hit hit,
      int id) {
    int nearPart = SIDE;
    int farPart = SIDE;
    if (ds == 0) {
      if (!(fs >= 0 && fs <= height)) {
        return;
      }
    } else {
      double toBase = -fs / ds;
      double toTop = (height - fs) / ds;
      if (Math.min(toBase, toTop) > near) {
        near = Math.min(toBase, toTop);
        nearPart = toBase < toTop ? BASE : TOP;
      }
      if (Math.max(toBase, toTop) < far) {
        far = Math.max(toBase, toTop);
        farPart = toBase < toTop ? TOP : BASE;
      }
    }
    if (near <= far) {
      hit.offerSolid(ray, start + near, start + far, id, nearPart, farPart);
    }
  }

  /** Returns whether a cap was hit. */
  static boolean isCap(Hit hit) {
    return hit.u != SIDE;
  }

  /** Projects the point onto the part that was hit. */
  static void resolve(double[] data, int at, Ray ray, Hit hit) {
    double ax = data[at + 3];
    double ay = data[at + 4];
    double az = data[at + 5];
    double height = data[at + 6];
    double radius = data[at + 7];
    double slope = data[at + 8];
    double fx = ray.ox - data[at] + hit.t * ray.dx;
    double fy = ray.oy - data[at + 1] + hit.t * ray.dy;
    double fz = ray.oz - data[at + 2] + hit.t * ray.dz;
    double s = fx * ax + fy * ay + fz * az;
    double wx = fx - s * ax;
    double wy = fy - s * ay;
    double wz = fz - s * az;
    int part = (int) hit.u;
    hit.curved = part == SIDE;
    if (part == SIDE) {
      s = Math.min(Math.max(s, 0), height);
      double length2 = wx * wx + wy * wy + wz * wz;
      double along = wx * ax + wy * ay + wz * az;
      if (!(length2 >= Double.MIN_NORMAL && along * along < 0.25 * length2)) {
        // At a tip, or from so far that rounding hides where around the axis: anywhere is as good.
        boolean steep = Math.abs(ax) < 0.6;
        wx = steep ? 0 : -az;
        wy = steep ? az : 0;
        wz = steep ? -ay : ax;
        length2 = wx * wx + wy * wy + wz * wz;
      }
      double unit = 1 / Math.sqrt(length2);
      hit.setNormal(wx * unit - slope * ax, wy * unit - slope * ay, wz * unit - slope * az);
      double stretch = (radius + slope * s) * unit;
      wx *= stretch;
      wy *= stretch;
      wz *= stretch;
    } else {
      s = part == BASE ? 0 : height;
      double outward = part == BASE ? -1 : 1;
      hit.nx = outward * ax;
      hit.ny = outward * ay;
      hit.nz = outward * az;
    }
    hit.px = data[at] + s * ax + wx;
    hit.py = data[at + 1] + s * ay + wy;
    hit.pz = data[at + 2] + s * az + wz;
    double widest = Math.max(radius, radius + slope * height);
    double size =
        Math.abs(data[at]) + Math.abs(data[at + 1]) + Math.abs(data[at + 2]) + height + widest;
    hit.offset = 16 * 0x1p-52 * size;
  }
}

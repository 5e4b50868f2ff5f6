package glint.geometry;

/**
 * Where a ray meets a surface; scratch, owned by one worker.
 *
 * <p>The kernels write only {@link #t}, {@link #primitive} and two local numbers while they search;
 * {@link Primitives#resolve} fills in point, normal and surface once, for the hit that won. The
 * only way to start a secondary ray is from a hit, which moves the origin off the surface by a
 * bound derived from the rounding of the hit point, so that nobody needs a bias.
 */
public final class Hit {

  /** The {@link #primitive} of a search that has found nothing. */
  public static final int NONE = Integer.MAX_VALUE;

  /**
   * No hit is farther than this along a ray of unit direction: no two points of bounded surfaces
   * are, and where planes end, no one sees.
   */
  public static final double FARTHEST = 0x1p336;

  /** The parameter of the closest hit so far, or the end of the search. */
  public double t;

  /** The number of the primitive hit, in scene order, or {@link #NONE}. */
  public int primitive;

  /** Where the primitive hit stands in its arrays. */
  int slot;

  /** Whether the ray enters the surface's inside here (1), leaves it (-1), or only touches (0). */
  public int crossing;

  /** Two numbers that the kernel keeps for itself: barycentrics, or the part that was hit. */
  double u;

  double v;

  /** The point, projected onto the surface. */
  public double px;

  public double py;
  public double pz;

  /** The unit normal, on the side that the surface calls its outside. */
  public double nx;

  public double ny;
  public double nz;

  /** The number of the surface, in scene order. */
  public int surface;

  /** How far along the normal a point is certain to lie off the surface, in scene units. */
  double offset;

  /** Begins a search for hits up to and including {@code tMax}, but never beyond the farthest. */
  public void begin(double tMax) {
    t = Math.min(tMax, FARTHEST);
    primitive = NONE;
  }

  /** Returns whether the search found a hit. */
  public boolean found() {
    return primitive != NONE;
  }

  /** Records a hit if it is in range and closer; equal parameters go to the lower primitive. */
  void offer(Ray ray, double local, int id, int newCrossing, double newU, double newV) {
    double candidate = local * ray.unit;
    if (candidate > 0
        && candidate >= ray.least
        && (candidate < t || (candidate == t && id < primitive))
        && ray.reaches(local, id)) {
      t = candidate;
      primitive = id;
      crossing = newCrossing;
      u = newU;
      v = newV;
    }
  }

  /** Sets the normal to the unit vector of a direction of any length but zero. */
  void setNormal(double x, double y, double z) {
    // Divide by a power of two first, so that no square overflows or vanishes.
    double scale = Ray.power(-Ray.exponent(x, y, z));
    double sx = x * scale;
    double sy = y * scale;
    double sz = z * scale;
    double inverse = 1 / Math.sqrt(sx * sx + sy * sy + sz * sz);
    nx = sx * inverse;
    ny = sy * inverse;
    nz = sz * inverse;
  }

  /**
   * Records the hit with a solid, which the ray enters at {@code near} and leaves at {@code far}.
   */
  void offerSolid(Ray ray, double near, double far, int id, double nearPart, double farPart) {
    boolean outside = ray.reaches(near, id);
    int through = near < far ? 1 : 0;
    if (outside) {
      offer(ray, near, id, through, nearPart, 0);
    } else {
      offer(ray, far, id, -through, farPart, 0);
    }
  }

  /** Returns how much further along a ray a point is certain to be clear of this surface. */
  public double clearance(Ray ray) {
    return 2 * offset / Math.abs(ray.dx * nx + ray.dy * ny + ray.dz * nz);
  }

  /** Turns the normal to the side that a ray comes from. */
  public void face(Ray ray) {
    if (ray.dx * nx + ray.dy * ny + ray.dz * nz > 0) {
      nx = -nx;
      ny = -ny;
      nz = -nz;
    }
  }

  /** Makes this the same hit as another. */
  public void copy(Hit other) {
    t = other.t;
    primitive = other.primitive;
    slot = other.slot;
    crossing = other.crossing;
    u = other.u;
    v = other.v;
    px = other.px;
    py = other.py;
    pz = other.pz;
    nx = other.nx;
    ny = other.ny;
    nz = other.nz;
    surface = other.surface;
    offset = other.offset;
  }

  /** Turns the inside out. */
  void reverse() {
    crossing = -crossing;
    nx = -nx;
    ny = -ny;
    nz = -nz;
  }

  /** Sets {@code ray} to leave this point in a direction of any length, on the side it leads to. */
  public void spawn(double dx, double dy, double dz, Ray ray) {
    double side = dx * nx + dy * ny + dz * nz < 0 ? -offset : offset;
    ray.set(px + side * nx, py + side * ny, pz + side * nz, dx, dy, dz);
  }

  /**
   * Sets {@code ray} to lead from this point to a target, with a direction of length 1 to 4.
   *
   * @return the last parameter before the target, which is no part of the way
   */
  public double spawnTo(double x, double y, double z, Ray ray) {
    double side = (x - px) * nx + (y - py) * ny + (z - pz) * nz < 0 ? -offset : offset;
    double ox = px + side * nx;
    double oy = py + side * ny;
    double oz = pz + side * nz;
    double dx = x - ox;
    double dy = y - oy;
    double dz = z - oz;
    int exponent = Ray.exponent(dx, dy, dz);
    double scale = Ray.power(-exponent);
    ray.set(ox, oy, oz, dx * scale, dy * scale, dz * scale);
    return Ray.power(exponent) * BEFORE_ONE;
  }

  private static final double BEFORE_ONE = 1 - 0x1p-53;
}

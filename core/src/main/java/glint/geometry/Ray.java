package glint.geometry;

/**
 * A half-line {@code o + t d} with {@code t > tMin}; scratch, owned by one worker.
 *
 * <p>The direction has any length; {@code t} counts in units of it. Besides origin and direction it
 * holds the shear that takes the direction to the unit z axis (Woop, Benthin, Wald 2013, Watertight
 * Ray/Triangle Intersection), computed once a ray, when the first triangle asks for it.
 */
public final class Ray {

  public double ox;
  public double oy;
  public double oz;
  public double dx;
  public double dy;
  public double dz;

  /**
   * Hits before this parameter, of the ray in the world, do not count, nor those at it up to the
   * primitive {@link #after}.
   */
  public double tMin;

  /** When, 0 to 1 of the time that the shutter is open, it is on its way. */
  public double time;

  /** The same ray beside a surface that moves; made when it is first needed. */
  private Ray companion;

  /** The last primitive at {@link #tMin} itself that does not count; by default none there does. */
  int after;

  /** Of the instance {@link #after}, the last triangle that does not count. */
  int afterPart;

  /** The primitive that it leaves outward and does not meet again if that is convex: no model. */
  int left;

  /** What a kernel's parameter is multiplied by to get that of the ray in the world. */
  double unit = 1;

  /** Whether the numbers below are those of this ray. */
  private boolean sheared;

  // The axis of the largest direction component, the two others in winding order, and the shear.
  int kx;
  int ky;
  int kz;
  double okx;
  double oky;
  double okz;
  double shearX;
  double shearY;
  double shearZ;

  /**
   * Sets origin and direction but not the time, starting at the origin itself, which does not
   * count.
   */
  public void set(double ox, double oy, double oz, double dx, double dy, double dz) {
    this.ox = ox;
    this.oy = oy;
    this.oz = oz;
    this.dx = dx;
    this.dy = dy;
    this.dz = dz;
    tMin = 0;
    after = Hit.NONE;
    left = Hit.NONE;
    sheared = false;
  }

  /** Makes this the same ray as another, which may go on among other primitives. */
  public void copy(Ray other) {
    set(other.ox, other.oy, other.oz, other.dx, other.dy, other.dz);
    tMin = other.tMin;
    after = other.after;
    time = other.time;
    afterPart = other.afterPart;
  }

  Ray companion() {
    if (companion == null) {
      companion = new Ray();
    }
    return companion;
  }

  /** Sets this ray to go on behind a hit, in the order of t and then of primitives. */
  public void goOnAfter(Hit hit) {
    tMin = hit.t;
    after = hit.primitive;
    afterPart = hit.part;
  }

  /** Returns by what a parameter in the world is multiplied to get this ray's: a power of two. */
  public double perWorldUnit() {
    return unit == 1 ? 1 : 1 / unit;
  }

  /** Returns whether a hit, at a parameter of the ray in the world, is far enough to count. */
  boolean reaches(double t, int primitive) {
    return t > tMin || (t == tMin && primitive > after);
  }

  /** Returns the exponent of the largest component: at least -1023. */
  static int exponent(double x, double y, double z) {
    return Math.max(Math.getExponent(x), Math.max(Math.getExponent(y), Math.getExponent(z)));
  }

  /** Returns 2 to a power from -1022 to 1023. */
  static double power(int exponent) {
    return Double.longBitsToDouble((long) (exponent + 1023) << 52);
  }

  /** Finds the shear, unless that was done. */
  void shear() {
    if (!sheared) {
      sheared = true;
      findShear();
    }
  }

  private void findShear() {
    double ax = Math.abs(dx);
    double ay = Math.abs(dy);
    double az = Math.abs(dz);
    double dkx;
    double dky;
    double dkz;
    if (ax >= ay && ax >= az) {
      kz = 0;
      kx = 1;
      ky = 2;
      okx = oy;
      oky = oz;
      okz = ox;
      dkx = dy;
      dky = dz;
      dkz = dx;
    } else if (ay >= az) {
      kz = 1;
      kx = 2;
      ky = 0;
      okx = oz;
      oky = ox;
      okz = oy;
      dkx = dz;
      dky = dx;
      dkz = dy;
    } else {
      kz = 2;
      kx = 0;
      ky = 1;
      okx = ox;
      oky = oy;
      okz = oz;
      dkx = dx;
      dky = dy;
      dkz = dz;
    }
    shearX = dkx / dkz;
    shearY = dky / dkz;
    shearZ = 1 / dkz;
  }
}

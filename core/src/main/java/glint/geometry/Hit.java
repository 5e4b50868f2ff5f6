package glint.geometry;

import glint.math.Rounding;
import glint.math.Transform;

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

  /** Between these, the square of a length has all of its digits, though single terms vanish. */
  private static final double LEAST_SQUARE = 0x1p-800;

  private static final double MOST_SQUARE = 0x1p800;

  /** The parameter of the closest hit so far, or the end of the search. */
  public double t;

  /** The number of the primitive hit, in scene order, or {@link #NONE}. */
  public int primitive;

  /** Where the primitive hit stands in its arrays. */
  int slot;

  /** Of an instance, the number of the triangle in its model, and where that stands there. */
  int part;

  int partSlot;

  /**
   * The least parameter of anything else that the search came upon; where the ray enters a solid,
   * that counts as well which leads out of it.
   */
  public double next;

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

  /**
   * The unit normal that light sees, once {@link #face} was called: of a smooth mesh that of the
   * curved surface that its triangles stand for, else the normal.
   */
  public double sx;

  public double sy;
  public double sz;

  /** From the point to the curved surface that it stands for. */
  double liftX;

  double liftY;
  double liftZ;

  /** Whether {@link #face} turned the normal over (-1) or left it (1); 0 if it is of another. */
  int side;

  /** The number of the surface, in scene order. */
  public int surface;

  /** Whether the surface is curved there, so that its normal turns from place to place. */
  public boolean curved;

  /** How far the surface has moved there; 0 where it stands still. */
  public double movedX;

  public double movedY;
  public double movedZ;

  /** When it is met, 0 to 1 of the time that the shutter is open. */
  public double time;

  /** How far along the normal a point is certain to lie off the surface, in scene units. */
  double offset;

  /** Where on an image the point lies, once {@link Mesh#findTexture} was called. */
  public double textureU;

  public double textureV;

  /** Scratch: the numbers of a transform. */
  final double[] numbers = new double[Transform.NUMBERS];

  /** Begins a search for hits up to and including {@code tMax}, but never beyond the farthest. */
  public void begin(double tMax) {
    t = Math.min(tMax, FARTHEST);
    next = Double.POSITIVE_INFINITY;
    primitive = NONE;
  }

  /** Returns whether the search found a hit. */
  public boolean found() {
    return primitive != NONE;
  }

  /** Returns where the primitive that was hit stands in its arrays. */
  public int slot() {
    return slot;
  }

  /** Records a hit if it is in range and closer; equal parameters go to the lower primitive. */
  void offer(Ray ray, double local, int id, int newCrossing, double newU, double newV) {
    double candidate = local * ray.unit;
    if (!(candidate > 0 && ray.reaches(candidate, id))) {
      return;
    }
    if (candidate < t || (candidate == t && id < primitive)) {
      next = t;
      t = candidate;
      primitive = id;
      crossing = newCrossing;
      u = newU;
      v = newV;
    } else {
      passBy(candidate);
    }
  }

  /** Takes note of a parameter that is not the least of all. */
  void passBy(double other) {
    if (other < next) {
      next = other;
    }
  }

  /**
   * Sets the normal to the unit vector of a direction of any length but zero; the same, bit for
   * bit, for all powers of two times it.
   */
  void setNormal(double x, double y, double z) {
    double squared = x * x + y * y + z * z;
    if (squared >= LEAST_SQUARE && squared <= MOST_SQUARE) {
      double inverse = 1 / Math.sqrt(squared);
      nx = x * inverse;
      ny = y * inverse;
      nz = z * inverse;
    } else {
      double scale = Ray.power(-Ray.exponent(x, y, z));
      double sx = x * scale;
      double sy = y * scale;
      double sz = z * scale;
      double inverse = 1 / Math.sqrt(sx * sx + sy * sy + sz * sz);
      nx = sx * inverse;
      ny = sy * inverse;
      nz = sz * inverse;
    }
  }

  /**
   * Sets the shading normal to the unit vector of a direction of any length but zero.
   *
   * <p>A quotient by a rounded root has length 1 to within 3.5u. One Newton step, for which its
   * squares are known exactly, leaves the rounding of the components and of three differences:
   * 1.5u.
   */
  void setShading(double x, double y, double z) {
    double scale = Ray.power(-Ray.exponent(x, y, z));
    double x1 = x * scale;
    double y1 = y * scale;
    double z1 = z * scale;
    double length = Math.sqrt(x1 * x1 + y1 * y1 + z1 * z1);
    sx = x1 / length;
    sy = y1 / length;
    sz = z1 / length;
    double missing = 1 - sx * sx - sy * sy - sz * sz;
    missing -= Rounding.ofSquare(sx) + Rounding.ofSquare(sy) + Rounding.ofSquare(sz);
    sx += sx * missing / 2;
    sy += sy * missing / 2;
    sz += sz * missing / 2;
  }

  /**
   * Records the hit with a solid, which the ray enters at {@code near} and leaves at {@code far}.
   */
  void offerSolid(Ray ray, double near, double far, int id, double nearPart, double farPart) {
    boolean outside = ray.reaches(near * ray.unit, id);
    int through = near < far ? 1 : 0;
    if (outside) {
      offer(ray, near, id, through, nearPart, 0);
      passBy(far * ray.unit);
    } else {
      offer(ray, far, id, -through, farPart, 0);
    }
  }

  /** Returns how much further along a ray a point is certain to be clear of this surface. */
  public double clearance(Ray ray) {
    return 2 * offset / Math.abs(ray.dx * nx + ray.dy * ny + ray.dz * nz);
  }

  /** Returns how far ahead of this point a ray of unit direction that was spawned here starts. */
  public double lead(Ray ray) {
    return offset * Math.abs(ray.dx * nx + ray.dy * ny + ray.dz * nz);
  }

  /** Turns the normal to the side that a ray comes from; light sees the same one. */
  public void face(Ray ray) {
    side = ray.dx * nx + ray.dy * ny + ray.dz * nz > 0 ? -1 : 1;
    nx *= side;
    ny *= side;
    nz *= side;
    sx = nx;
    sy = ny;
    sz = nz;
    liftX = 0;
    liftY = 0;
    liftZ = 0;
  }

  /** Makes this the same hit as another. */
  public void copy(Hit other) {
    t = other.t;
    next = other.next;
    primitive = other.primitive;
    slot = other.slot;
    part = other.part;
    partSlot = other.partSlot;
    crossing = other.crossing;
    u = other.u;
    v = other.v;
    px = other.px;
    py = other.py;
    pz = other.pz;
    nx = other.nx;
    ny = other.ny;
    nz = other.nz;
    sx = other.sx;
    sy = other.sy;
    sz = other.sz;
    liftX = other.liftX;
    liftY = other.liftY;
    liftZ = other.liftZ;
    side = other.side;
    surface = other.surface;
    offset = other.offset;
    movedX = other.movedX;
    movedY = other.movedY;
    movedZ = other.movedZ;
    time = other.time;
    curved = other.curved;
  }

  /** Takes over which part of which surface was hit, but neither point nor normal. */
  public void copyPart(Hit other) {
    primitive = other.primitive;
    slot = other.slot;
    part = other.part;
    partSlot = other.partSlot;
    u = other.u;
    v = other.v;
    side = 0;
    surface = other.surface;
  }

  /** Begins to resolve a hit of a time, with what stands still. */
  void stand(double at) {
    time = at;
    movedX = 0;
    movedY = 0;
    movedZ = 0;
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
    leave(dx * nx + dy * ny + dz * nz < 0 ? -offset : offset, dx, dy, dz, ray);
  }

  /**
   * Sets {@code ray} to leave this point, which was faced, on the normal's side (1) or the other
   * (-1).
   *
   * <p>A direction that was mirrored or bent by the shading normal may lead to the wrong side of
   * the true surface. It is then mirrored once more, by that; 16u cover all rounding of it.
   *
   * @param dx the direction, of length 1
   */
  public void spawn(double dx, double dy, double dz, int toSide, Ray ray) {
    double rise = toSide * (dx * nx + dy * ny + dz * nz);
    if (rise < 0) {
      double more = toSide * (16 * Rounding.U - 2 * rise);
      double x = dx + more * nx;
      double y = dy + more * ny;
      double z = dz + more * nz;
      double length = Math.sqrt(x * x + y * y + z * z);
      leave(toSide * offset, x / length, y / length, z / length, ray);
    } else {
      leave(toSide * offset, dx, dy, dz, ray);
    }
    ray.left = toSide == side ? primitive : NONE;
  }

  private void leave(double along, double dx, double dy, double dz, Ray ray) {
    ray.set(px + along * nx, py + along * ny, pz + along * nz, dx, dy, dz);
    ray.time = time;
  }

  /** Sets {@code ray} to lead from this point, which was faced, to light in a direction. */
  public void spawnToLight(double dx, double dy, double dz, Ray ray) {
    double ox = px + liftX + offset * nx;
    double oy = py + liftY + offset * ny;
    double oz = pz + liftZ + offset * nz;
    ray.set(ox, oy, oz, dx, dy, dz);
    ray.time = time;
    boolean outward = side > 0 && dx * nx + dy * ny + dz * nz >= 0;
    ray.left = outward ? primitive : NONE;
  }

  /**
   * Sets {@code ray} to lead from this point, which was faced, to a light's place, with a direction
   * of length 1 to 4.
   *
   * @return the last parameter before the place, which is no part of the way
   */
  public double spawnTo(double x, double y, double z, Ray ray) {
    double dx = x - (px + liftX + offset * nx);
    double dy = y - (py + liftY + offset * ny);
    double dz = z - (pz + liftZ + offset * nz);
    int exponent = Ray.exponent(dx, dy, dz);
    double scale = Ray.power(-exponent);
    spawnToLight(dx * scale, dy * scale, dz * scale, ray);
    return Ray.power(exponent) * BEFORE_ONE;
  }

  private static final double BEFORE_ONE = 1 - 0x1p-53;
}

package glint.light;

import glint.geometry.Hit;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.math.Vector3d;
import glint.sampling.Direction;
import glint.sampling.Disc;
import glint.sampling.SobolSampler;

/** A sphere that shines outwards; immutable. */
final class BallLamp implements Lamp {

  /** The lamp is taken whole while its lowest point has this share of the middle's cosine. */
  private static final double HIGH = 0.5;

  private final Vector3d center;
  private final double radius;

  BallLamp(Vector3d center, double radius) {
    this.center = center;
    this.radius = radius;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Where the sphere is well above the surface's horizon, directions are as dense as their
   * cosine, so that every one brings the same diffuse light: the cap of the unit sphere that it
   * covers has an ellipse for a shadow straight below (Nusselt's analogon), to which a disc is
   * mapped. Elsewhere directions are even over the cone (Shirley, Wang and Zimmerman, Monte Carlo
   * Techniques for Direct Lighting Calculations, ACM Transactions on Graphics 15(1), 1996).
   */
  @Override
  public double sample(Hit hit, SobolSampler numbers, LightSample out) {
    double wx = center.x() - hit.px;
    double wy = center.y() - hit.py;
    double wz = center.z() - hit.pz;
    double d = Math.sqrt(wx * wx + wy * wy + wz * wz);
    if (!(d > radius)) {
      return 0;
    }
    wx /= d;
    wy /= d;
    wz /= d;
    double sin = radius / d;
    double cos = Math.sqrt((d - radius) * (d + radius)) / d;
    if (numbers.isCentred()) {
      out.lead(wx, wy, wz);
      out.place(center.x(), center.y(), center.z());
      return sin * sin;
    }
    double up = wx * hit.sx + wy * hit.sy + wz * hit.sz;
    double low = up * cos - sin * Math.sqrt(Math.max(0, 1 - up * up));
    Disc disc = out.disc;
    disc.at(numbers.u, numbers.v);
    Direction way = out.way;
    double strength;
    if (up > 0 && low >= HIGH * up) {
      // Rise from the cap's flat base to the cap, along the normal.
      way.around(wx, wy, wz, cos, sin * disc.a, sin * disc.b);
      double above = way.x * hit.sx + way.y * hit.sy + way.z * hit.sz;
      double left = sin * sin * Math.max(0, 1 - disc.squared());
      double rise = left / (above + Math.sqrt(above * above + left));
      out.lead(way.x + rise * hit.sx, way.y + rise * hit.sy, way.z + rise * hit.sz);
      strength = sin * sin * up / (above + rise);
    } else {
      double height = sin * sin / (1 + cos);
      double below = height * disc.squared();
      double aside = Math.sqrt(height * (2 - below));
      way.around(wx, wy, wz, 1 - below, aside * disc.a, aside * disc.b);
      out.lead(way.x, way.y, way.z);
      strength = 2 * height;
    }
    double along = wx * out.lx + wy * out.ly + wz * out.lz;
    double x = out.lx - along * wx;
    double y = out.ly - along * wy;
    double z = out.lz - along * wz;
    // Go to the nearer point of the sphere on that way, or to where it touches the sphere.
    double half = Math.sqrt(Math.max(0, radius * radius - d * d * (x * x + y * y + z * z)));
    double t = (d - radius) * (d + radius) / (d * along + half);
    out.place(hit.px + t * out.lx, hit.py + t * out.ly, hit.pz + t * out.lz);
    return strength;
  }

  @Override
  public Surface shape() {
    return new Sphere(center, radius);
  }
}

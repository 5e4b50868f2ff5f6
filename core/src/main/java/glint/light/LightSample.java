package glint.light;

import glint.color.Rgb;

/** What one light sends to one point; scratch, owned by one worker. */
public final class LightSample {

  /** The unit vector from the point towards the light. */
  public double lx;

  public double ly;
  public double lz;

  /** The light's colour times its strength at the point. */
  public double r;

  public double g;
  public double b;

  void set(double x, double y, double z, Rgb color, double strength) {
    lx = x;
    ly = y;
    lz = z;
    r = color.r() * strength;
    g = color.g() * strength;
    b = color.b() * strength;
  }
}

package glint.light;

import glint.color.Rgb;
import glint.sampling.Bilinear;
import glint.sampling.Direction;
import glint.sampling.Disc;

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

  /** Where the light comes from, if that is a place. */
  double px;

  double py;
  double pz;

  /** Scratch of lamps. */
  final Disc disc = new Disc();

  final Bilinear warp = new Bilinear();
  final Direction way = new Direction();

  void set(double x, double y, double z, Rgb color, double strength) {
    lead(x, y, z);
    shine(color, strength);
  }

  void shine(Rgb color, double strength) {
    r = color.r() * strength;
    g = color.g() * strength;
    b = color.b() * strength;
  }

  void lead(double x, double y, double z) {
    lx = x;
    ly = y;
    lz = z;
  }

  void place(double x, double y, double z) {
    px = x;
    py = y;
    pz = z;
  }
}

package glint.models;

import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Loft;
import glint.models.shape.Noise;
import glint.models.shape.Shape;
import glint.models.shape.Spline;
import glint.models.shape.Sweep;
import java.util.ArrayList;
import java.util.List;

/** A candle of height 1 and radius 0.2 that has burnt for a while, and its flame. */
final class Candle {

  private static final int SEGMENTS = 36;
  private static final double RADIUS = 0.2;
  private static final int BANDS = 8;

  /** Angle, length and width of what has run down. */
  private static final double[][] RUNS = {
    {0.3, 0.42, 0.2},
    {1.1, 0.2, 0.16},
    {1.75, 0.6, 0.22},
    {2.8, 0.3, 0.18},
    {3.5, 0.72, 0.2},
    {4.2, 0.24, 0.15},
    {4.9, 0.5, 0.22},
    {5.7, 0.34, 0.18}
  };

  private static final Noise NOISE = new Noise(3);

  private Candle() {}

  /** Returns the candle; the nearer to the flame, the more the wax shines through. */
  static Model candle() {
    Model model = new Model();
    Shape wax = wax();
    for (int i = 0; i <= BANDS; i++) {
      int band = i;
      double share = (double) i / BANDS;
      model.add(wax("wax" + i, share * share), wax.where(p -> band(p.y()) == band));
    }
    List<Vector3d> path =
        Spline.through(
            4, new Vector3d(0, 0.92, 0), new Vector3d(0.004, 1, 0), new Vector3d(0.02, 1.06, 0));
    return model.add(Paint.dull("wick", 0.02, 0.015, 0.01), Sweep.tube(path, 6, t -> 0.012));
  }

  /** Returns 0 for the lower half and, above it, a number that grows with the height. */
  private static int band(double y) {
    return (int) Math.max(0, Math.min(BANDS, Math.ceil((2 * y - 1) * BANDS)));
  }

  private static Paint wax(String name, double glow) {
    return Paint.dull(name, 0.75, 0.66, 0.5)
        .shiny(0.15, 40)
        .glowing(0.5 * glow, 0.22 * glow, 0.06 * glow);
  }

  private static Shape wax() {
    List<List<Vector3d>> rings = new ArrayList<>();
    for (int i = 0; i <= 20; i++) {
      rings.add(side(i / 20.0));
    }
    for (double[] rim : new double[][] {{0.9, 0.012}, {0.78, 0.005}, {0.7, -0.02}, {0.4, -0.04}}) {
      rings.add(inside(rim[0], rim[1]));
    }
    return Loft.body(Vector3d.ZERO, rings, new Vector3d(0, 0.955, 0));
  }

  /** The wall at a share of the height, with what has run down it. */
  private static List<Vector3d> side(double share) {
    List<Vector3d> ring = new ArrayList<>();
    for (Vector3d p : Lathe.ring(SEGMENTS, 1, 0)) {
      double radius = RADIUS + 0.006 * NOISE.at(p.times(2).plus(new Vector3d(0, 6 * share, 0)));
      double angle = StrictMath.atan2(p.x(), p.z());
      for (double[] run : RUNS) {
        double away = Math.IEEEremainder(angle - run[0], 2 * Math.PI) / run[2];
        double below = (1 - share) / run[1];
        if (below < 1) {
          double bulb = 0.4 + 0.6 * below * below;
          radius += 0.05 * bulb * StrictMath.exp(-4 * away * away) * Math.sqrt(1 - below * below);
        }
      }
      ring.add(new Vector3d(p.x() * radius, share * top(p), p.z() * radius));
    }
    return ring;
  }

  /** The rim and the hollow within it. */
  private static List<Vector3d> inside(double share, double rise) {
    List<Vector3d> ring = new ArrayList<>();
    for (Vector3d p : Lathe.ring(SEGMENTS, 1, 0)) {
      double y = top(p) * share + (1 - share) + rise;
      ring.add(new Vector3d(p.x() * RADIUS * share, y, p.z() * RADIUS * share));
    }
    return ring;
  }

  private static double top(Vector3d around) {
    return 1 + 0.03 * NOISE.at(around.times(1.3).plus(new Vector3d(5, 0, 0)));
  }

  /** Returns the flame: its foot is the origin, its height 0.34. */
  static Model flame() {
    Shape outer =
        Lathe.body(
            20, 0, 0, .025, .008, .042, .03, .052, .065, .053, .1, .047, .145, .036, .2, .022, .26,
            .01, .31, 0, .34);
    Shape inner =
        Lathe.body(16, 0, .02, .018, .03, .03, .055, .034, .085, .03, .12, .018, .17, 0, .23);
    return new Model()
        .add(Paint.dull("flame", 0, 0, 0).glowing(0.6, 0.22, 0.04).covering(0.4), outer)
        .add(Paint.dull("heart", 0, 0, 0).glowing(0.7, 0.55, 0.25).covering(0.6), inner);
  }
}

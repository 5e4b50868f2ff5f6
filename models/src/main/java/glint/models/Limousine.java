package glint.models;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.models.shape.Lathe;
import glint.models.shape.Loft;
import glint.models.shape.Shape;
import glint.models.shape.Superellipsoid;
import glint.models.shape.Sweep;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;

/** A stretched limousine, 8 m long; it stands on y = 0 and drives along −x. */
final class Limousine {

  private static final double HALF_WIDTH = 0.95;
  private static final double AXLE_FRONT = -2.75;
  private static final double AXLE_REAR = 2.6;
  private static final double ARCH = 0.44;
  private static final double AXLE_HEIGHT = 0.36;
  private static final double SILL = 0.24;

  /** Along the car: place, height of the upper edge, half width as a share. */
  private static final double[][] STATIONS = {
    {-4.0, 0.72, 0.84},
    {-3.93, 0.8, 0.93},
    {-3.7, 0.86, 0.97},
    {-3.0, 0.92, 0.99},
    {-1.9, 0.97, 1},
    {0, 1.0, 1},
    {1.9, 1.0, 1},
    {2.9, 0.99, 1},
    {3.6, 0.95, 0.98},
    {3.86, 0.9, 0.94},
    {3.94, 0.8, 0.86}
  };

  private static final Paint BLACK =
      Paint.dull("paint", 0.006, 0.006, 0.008).mirror(0.16, 0.16, 0.17, 300);
  private static final Paint CHROME =
      Paint.dull("chrome", 0.03, 0.03, 0.03).mirror(0.7, 0.71, 0.73, 300);
  private static final Paint GLASS =
      Paint.dull("glass", 0.004, 0.005, 0.006).mirror(0.22, 0.22, 0.24, 500);
  private static final Paint RUBBER = Paint.dull("rubber", 0.012, 0.012, 0.012).shiny(0.08, 12);
  private static final Paint CABIN =
      Paint.dull("cabin", 0.1, 0.05, 0.02).glowing(0.16, 0.075, 0.025);
  private static final Paint HEAD = Paint.dull("headlight", 0, 0, 0).glowing(1.2, 1.12, 0.9);
  private static final Paint TAIL = Paint.dull("taillight", 0.1, 0, 0).glowing(1.0, 0.03, 0.015);

  private Limousine() {}

  static Model model() {
    Model model = new Model().add(BLACK, body());
    cabin(model);
    for (double axle : new double[] {AXLE_FRONT, AXLE_REAR}) {
      model.add(RUBBER, onWheel(tyre(), axle)).add(CHROME, onWheel(hub(), axle));
    }
    return model.add(CHROME, trim()).add(HEAD, headlights()).add(TAIL, taillights());
  }

  /** The body below the windows: sections from nose to tail, dense at the wheel arches. */
  private static Shape body() {
    TreeSet<Double> places = new TreeSet<>();
    for (double[] station : STATIONS) {
      places.add(station[0]);
    }
    for (double axle : new double[] {AXLE_FRONT, AXLE_REAR}) {
      for (int i = 0; i <= 12; i++) {
        places.add(axle - ARCH * StrictMath.cos(Math.PI * i / 12));
      }
      places.add(axle - ARCH * 1.002);
      places.add(axle + ARCH * 1.002);
    }
    List<List<Vector3d>> sections = new ArrayList<>();
    places.forEach(x -> sections.add(section(x)));
    double y = 0.5;
    return Loft.body(new Vector3d(-4.02, y, 0), sections, new Vector3d(3.96, y, 0));
  }

  /** A closed section, from the keel up the left side, over the top and down the right. */
  private static List<Vector3d> section(double x) {
    double top = along(x, 1);
    double half = HALF_WIDTH * along(x, 2);
    double bottom = bottom(x);
    List<Vector3d> left = new ArrayList<>();
    left.add(new Vector3d(x, bottom, 0.6 * half));
    for (int i = 0; i <= 5; i++) {
      double share = i / 5.0;
      double y = bottom + (top - 0.09 - bottom) * share;
      double belly = 1 - 0.05 * StrictMath.pow(Math.abs(y - 0.55) / 0.4, 2);
      left.add(new Vector3d(x, y, half * belly));
    }
    double shoulder = left.get(6).z();
    for (int i = 1; i <= 4; i++) {
      double angle = Math.PI / 2 * i / 4;
      left.add(
          new Vector3d(
              x,
              top - 0.09 + 0.07 * StrictMath.sin(angle),
              shoulder - 0.1 * (1 - StrictMath.cos(angle))));
    }
    left.add(new Vector3d(x, top - 0.008, 0.5 * half));
    List<Vector3d> ring = new ArrayList<>(left);
    ring.add(new Vector3d(x, top, 0));
    for (int i = left.size() - 1; i >= 0; i--) {
      Vector3d p = left.get(i);
      ring.add(new Vector3d(p.x(), p.y(), -p.z()));
    }
    ring.add(new Vector3d(x, bottom, 0));
    return ring;
  }

  private static double along(double x, int column) {
    int i = 1;
    while (i < STATIONS.length - 1 && STATIONS[i][0] < x) {
      i++;
    }
    double[] a = STATIONS[i - 1];
    double[] b = STATIONS[i];
    double t = (x - a[0]) / (b[0] - a[0]);
    return a[column] + (b[column] - a[column]) * t;
  }

  private static double bottom(double x) {
    double ends = Math.max(0, Math.abs(x) - 3.4);
    double sill = SILL + 0.12 * ends;
    for (double axle : new double[] {AXLE_FRONT, AXLE_REAR}) {
      double away = x - axle;
      if (Math.abs(away) < ARCH * 1.001) {
        double rise = AXLE_HEIGHT + Math.sqrt(Math.max(0, ARCH * ARCH - away * away));
        return Math.max(sill, rise);
      }
    }
    return sill;
  }

  /** The windows and the roof: rounded rectangles that grow narrower upwards. */
  private static void cabin(Model model) {
    List<List<Vector3d>> rings = new ArrayList<>();
    rings.add(cabinRing(0.97, 0));
    rings.add(cabinRing(1.03, 0.08));
    rings.add(cabinRing(1.36, 0.86));
    rings.add(cabinRing(1.42, 1.0));
    rings.add(cabinRing(1.455, 1.12));
    rings.add(cabinRing(1.475, 1.35));
    Shape shell = Loft.body(new Vector3d(0.25, 0.97, 0), rings, new Vector3d(0.25, 1.49, 0));
    Shape panes = shell.where(Limousine::isPane);
    model.add(BLACK, shell.where(p -> !isPane(p)));
    model.add(CABIN, panes.where(Limousine::isLit)).add(GLASS, panes.where(p -> !isLit(p)));
  }

  private static boolean isPane(Vector3d p) {
    boolean band = p.y() > 1.04 && p.y() < 1.35;
    boolean pillar = false;
    for (double x : new double[] {-1.15, -0.2, 0.95, 2.02}) {
      pillar |= Math.abs(p.x() - x) < 0.05 && Math.abs(p.z()) > 0.6;
    }
    return band && !pillar;
  }

  private static boolean isLit(Vector3d p) {
    return p.x() > -0.15 && p.x() < 0.9 && Math.abs(p.z()) > 0.6;
  }

  /** A ring of the cabin; the inset is 0 at the belt and 1 at the edge of the roof. */
  private static List<Vector3d> cabinRing(double y, double inset) {
    double front = -1.95 + 0.75 * inset;
    double rear = 2.75 - 0.55 * inset;
    double half = 0.86 - 0.17 * inset;
    List<Vector3d> ring = new ArrayList<>();
    double[] xs = {
      0, .02, .05, .1, .155, .18, .205, .25, .3, .36, .405, .425, .45, .5, .55, .6, .655, .675, .7,
      .75, .8, .865, .895, .92, .96, .985, 1
    };
    for (double share : xs) {
      double end = Math.min(share, 1 - share) / 0.05;
      double round = end < 1 ? 1 - 0.12 * (1 - end) * (1 - end) : 1;
      ring.add(new Vector3d(front + (rear - front) * share, y, half * round));
    }
    for (int i = xs.length - 1; i >= 0; i--) {
      Vector3d p = ring.get(i);
      ring.add(new Vector3d(p.x(), p.y(), -p.z()));
    }
    return ring;
  }

  private static Shape onWheel(Shape wheel, double axle) {
    Transform turn = Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 0, 0), 90));
    return wheel
        .moved(turn)
        .moved(axle, AXLE_HEIGHT, 0.8)
        .plus(
            wheel
                .moved(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 0, 0), -90)))
                .moved(axle, AXLE_HEIGHT, -0.8));
  }

  private static Shape tyre() {
    return Lathe.body(
        32, 0, -.11, .3, -.11, .345, -.08, .36, -.03, .36, .04, .345, .09, .3, .115, .24, .11, .235,
        .08, 0, .07);
  }

  private static Shape hub() {
    return Lathe.body(
        32, 0, 0.06, .228, .075, .232, .1, .215, .106, .19, .09, .1, .095, .07, .12, 0, .128);
  }

  private static Shape trim() {
    List<Shape> parts = new ArrayList<>();
    // Bumpers, and a strip along either side
    parts.add(box(-4.03, 0.4, 0, 0.09, 0.075, 0.9));
    parts.add(box(3.97, 0.42, 0, 0.09, 0.075, 0.88));
    for (double z : new double[] {-1, 1}) {
      parts.add(rod(-2.25, 0.34, 0.955 * z, 2.1, 0.34, 0.955 * z, 0.018));
      parts.add(rod(-1.88, 1.005, 0.865 * z, 2.55, 1.005, 0.865 * z, 0.014));
      for (double x : new double[] {-0.95, 0.15, 1.2}) {
        parts.add(rod(x, 0.82, 0.955 * z, x + 0.14, 0.82, 0.955 * z, 0.014));
      }
    }
    // The grille
    parts.add(box(-4.03, 0.83, 0, 0.05, 0.03, 0.34));
    for (int i = -6; i <= 6; i++) {
      parts.add(rod(-4.03, 0.52, 0.05 * i, -4.03, 0.82, 0.05 * i, 0.014));
    }
    // What stands on its top
    parts.add(rod(-4.03, 0.86, 0, -4.0, 0.98, 0, 0.012));
    return Shape.of(parts);
  }

  private static Shape headlights() {
    Shape lamp = Superellipsoid.of(new Vector3d(0.06, 0.08, 0.12), 0.5, 12, 8);
    return Shape.of(
        List.of(
            lamp.moved(-3.99, 0.68, 0.5), lamp.moved(-3.99, 0.68, 0.74),
            lamp.moved(-3.99, 0.68, -0.5), lamp.moved(-3.99, 0.68, -0.74)));
  }

  private static Shape taillights() {
    return box(3.95, 0.7, 0.56, 0.04, 0.07, 0.26).plus(box(3.95, 0.7, -0.56, 0.04, 0.07, 0.26));
  }

  private static Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return Superellipsoid.of(new Vector3d(dx, dy, dz), 0.3, 12, 6).moved(x, y, z);
  }

  private static Shape rod(
      double x1, double y1, double z1, double x2, double y2, double z2, double radius) {
    return Sweep.tube(List.of(new Vector3d(x1, y1, z1), new Vector3d(x2, y2, z2)), 8, t -> radius);
  }
}

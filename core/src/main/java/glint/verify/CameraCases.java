package glint.verify;

import glint.geometry.Ray;
import glint.math.BadValueException;
import glint.math.Rounding;
import glint.math.Vector3d;
import glint.render.RenderSettings;
import glint.scene.Camera;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.scene.View;
import glint.trace.Tracer;
import java.math.BigDecimal;
import java.util.List;
import java.util.Set;

/** From pixels to rays: middle, mirror image, angle of view, and cameras that cannot be. */
final class CameraCases {

  private CameraCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("C01", "the centre pixel looks forward", 1, "ulp(1)", CameraCases::center),
        HardCase.exact("C02", "a mirrored world, a mirrored picture", CameraCases::mirror),
        HardCase.within("C03", "vfov 90°: tan = (2y+1-H)/H", 2, "u", CameraCases::fieldOfView),
        HardCase.within("C04", "orthonormal next to the zenith", 4, "u", CameraCases::gimbal),
        HardCase.exact("C05", "one pixel, fov 1e-6°: the ray's radiance", CameraCases::onePixel));
  }

  private static void center(Tally tally) {
    Dice dice = new Dice(1);
    Ray ray = new Ray();
    for (int i = 0; i < 1000; i++) {
      Vector3d eye = dice.cube(10);
      Vector3d to = eye.plus(dice.unit().times(dice.log(0.1, 1e3)));
      Camera camera = Camera.of(eye, to, dice.unit(), Projection.vertical(dice.in(1, 170)));
      new View(camera, 97, 61).ray(48.5, 30.5, ray);
      Exact3 forward = Exact3.of(to).minus(Exact3.of(eye));
      BigDecimal length = Exact.sqrt(forward.squared());
      tally.check(ray.ox == eye.x() && ray.oy == eye.y() && ray.oz == eye.z());
      tally.error(off(ray.dx, forward.x(), length) / 2);
      tally.error(off(ray.dy, forward.y(), length) / 2);
      tally.error(off(ray.dz, forward.z(), length) / 2);
    }
  }

  private static void mirror(Tally tally) {
    SampleWorld plain = SampleWorld.PLAIN;
    SampleWorld other = new SampleWorld(plain.scale(), true, plain.offset(), SampleWorld.GLOSSY);
    Scene scene = plain.scene().build();
    double[] here = Pictures.pixels(plain.scene());
    double[] there = Pictures.pixels(other.scene());
    WorldCases.compare(here, turned(there, scene.width()), tally);
  }

  /** Returns a picture with left and right exchanged. */
  static double[] turned(double[] picture, int width) {
    double[] turned = new double[picture.length];
    for (int i = 0; i < picture.length; i += 3) {
      int pixel = i / 3;
      int back = pixel - pixel % width + width - 1 - pixel % width;
      System.arraycopy(picture, 3 * back, turned, i, 3);
    }
    return turned;
  }

  private static void fieldOfView(Tally tally) {
    Vector3d forward = new Vector3d(0, 0, -1);
    Camera camera = Camera.of(Vector3d.ZERO, forward, Pictures.UP, Projection.vertical(90));
    View view = new View(camera, 640, 480);
    Ray ray = new Ray();
    Ray opposite = new Ray();
    for (int y = 0; y < 480; y++) {
      for (int x = 0; x < 640; x += 71) {
        view.ray(x + 0.5, y + 0.5, ray);
        view.ray(640 - x - 0.5, 480 - y - 0.5, opposite);
        tally.check(ray.dx == -opposite.dx && ray.dy == -opposite.dy && ray.dz == opposite.dz);
        Exact3 truth = Exact3.of(2 * x + 1 - 640, 480 - 2 * y - 1, -480);
        BigDecimal length = Exact.sqrt(truth.squared());
        tally.error(off(ray.dx, truth.x(), length));
        tally.error(off(ray.dy, truth.y(), length));
        tally.error(off(ray.dz, truth.z(), length));
      }
    }
  }

  /** The error of a component of a unit vector, in u. */
  private static double off(double component, BigDecimal part, BigDecimal length) {
    BigDecimal error = Exact.of(component).subtract(Exact.ratio(part, length));
    return Exact.toDouble(error.abs()) / Rounding.U;
  }

  /** Along the view an up vector is refused; however near to it, the frame is orthonormal. */
  private static void gimbal(Tally tally) {
    Dice dice = new Dice(4);
    for (int i = 0; i < 1000; i++) {
      Vector3d eye = dice.cube(3);
      Vector3d view = dice.unit();
      double tilt = i % 4 == 0 ? 0 : dice.log(1e-12, 1);
      Vector3d up = view.times(dice.sign()).plus(dice.across(view).times(tilt));
      Projection lens = Projection.vertical(90);
      if (tilt == 0) {
        tally.check(isRefused(eye, view, up, lens));
      } else {
        frame(new View(Camera.of(eye, eye.plus(view), up, lens), 2, 2), tally);
      }
    }
  }

  private static boolean isRefused(Vector3d eye, Vector3d view, Vector3d up, Projection lens) {
    try {
      Camera.of(eye, eye.plus(view), up, lens);
      return false;
    } catch (BadValueException e) {
      return e.field().equals("up");
    }
  }

  /** Through the middles of the edges at 90° pass forward ± right and forward ± up, over √2. */
  static void frame(View view, Tally tally) {
    Exact3 east = direction(view, 2, 1);
    Exact3 west = direction(view, 0, 1);
    Exact3 north = direction(view, 1, 0);
    Exact3 south = direction(view, 1, 2);
    BigDecimal half = Exact.of(0.5);
    Exact3[] frame = {
      east.plus(west).plus(north).plus(south).times(half.multiply(half)),
      east.minus(west).times(half),
      north.minus(south).times(half)
    };
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k <= i; k++) {
        double dot =
            Exact.toDouble(
                frame[i]
                    .dot(frame[k])
                    .add(frame[i].dot(frame[k]))
                    .subtract(Exact.of(i == k ? 1 : 0)));
        tally.error(Math.abs(dot) / Rounding.U);
      }
    }
    tally.check(true);
  }

  private static Exact3 direction(View view, double x, double y) {
    Ray ray = new Ray();
    view.ray(x, y, ray);
    return Exact3.of(ray.dx, ray.dy, ray.dz);
  }

  private static void onePixel(Tally tally) {
    Dice dice = new Dice(5);
    for (int i = 0; i < 50; i++) {
      Vector3d eye = dice.unit().times(8);
      Projection lens = Projection.vertical(i % 2 == 0 ? 1e-6 : 40);
      Camera camera = Camera.of(eye, dice.cube(1), new Vector3d(0.1, 1, 0.2), lens);
      Scene scene = SampleWorld.PLAIN.scene().camera(camera).size(1, 1).build();
      double[] pixel = Pictures.render(scene, Set.of()).image().rgb();
      Ray ray = new Ray();
      double end = new View(camera, 1, 1).ray(0.5, 0.5, ray);
      Tracer tracer = new Tracer(Prepared.of(scene), RenderSettings.DEFAULT_DEPTH, 0);
      tracer.trace(ray, end);
      tally.check(pixel[0] == tracer.r && pixel[1] == tracer.g && pixel[2] == tracer.b);
    }
  }
}

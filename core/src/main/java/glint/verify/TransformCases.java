package glint.verify;

import glint.color.Rgb;
import glint.geometry.Primitives;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.List;
import java.util.Set;

/** Transforms of surfaces, and of whole worlds. */
final class TransformCases {

  private static final Vector3d THIN = new Vector3d(1, 10, 0.1);

  private TransformCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within(
            "Q07", "normals of an ellipsoid, 1:10:0.1", 1e-12, "-", TransformCases::normals),
        HardCase.exact("Q09", "transforms that flatten space are refused", TransformCases::flat),
        HardCase.within(
            "Q10", "world and camera turned and moved", 1e-12, "rmse", TransformCases::rigid));
  }

  private static void normals(Tally tally) {
    Dice dice = new Dice(7);
    for (int i = 0; i < tally.times(2000, 100_000); i++) {
      Transform place = Transform.scale(THIN.times(dice.sign()));
      Primitives.Builder builder = new Primitives.Builder();
      builder.add(new Sphere(Vector3d.ZERO, 1), place, 0);
      Shoot shoot = Shoot.scanning(builder.build());
      if (shoot.through(dice.unit().times(20), place.point(dice.unit()))) {
        shoot.resolve();
        Vector3d p = shoot.point();
        // The ellipsoid's gradient there, and two directions square to it.
        Vector3d g =
            new Vector3d(
                p.x() / (THIN.x() * THIN.x()),
                p.y() / (THIN.y() * THIN.y()),
                p.z() / (THIN.z() * THIN.z()));
        Vector3d across = dice.across(g);
        tally.error(Math.abs(shoot.normal().dot(across)));
        tally.error(Math.abs(shoot.normal().dot(g.normalized().cross(across))));
        tally.check(shoot.normal().dot(g) > 0);
      }
    }
  }

  private static void flat(Tally tally) {
    for (double bad : new double[] {0, -0.0, Double.NaN, Double.POSITIVE_INFINITY}) {
      tally.check(isRefused(() -> Transform.scale(new Vector3d(1, bad, 1))));
    }
    tally.check(isRefused(() -> Transform.matrix(1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0)));
    tally.check(isRefused(() -> Transform.matrix(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)));
    tally.check(isRefused(() -> Transform.matrix(1, 0, 0, Double.NaN, 0, 1, 0, 0, 0, 0, 1, 0)));
  }

  private static boolean isRefused(Runnable maker) {
    try {
      maker.run();
      return false;
    } catch (ArithmeticException e) {
      return true;
    }
  }

  private static Scene moved(Scene scene, Transform move) {
    Camera c = scene.camera();
    Scene.Builder other =
        new Scene.Builder("moved")
            .size(scene.width(), scene.height())
            .background(Background.constant(Rgb.grey(0.2)))
            .camera(
                Camera.of(
                    move.point(c.position()),
                    move.point(c.lookAt()),
                    move.direction(c.up()),
                    c.projection()));
    for (Light light : scene.lights()) {
      if (light instanceof Light.Point p) {
        other.light(new Light.Point(move.point(p.position()), p.color(), p.inverseSquare()));
      } else if (light instanceof Light.Directional d) {
        other.light(new Light.Directional(move.direction(d.direction()), d.color()));
      } else {
        other.light(light);
      }
    }
    for (Placement p : scene.placements()) {
      other.place(new Placement(p.surface(), p.toWorld().then(move), p.material()));
    }
    return other.build();
  }

  private static double[] pixels(Scene scene, int samples) {
    return Pictures.render(scene, samples, 1, 32, Set.of()).image().rgb();
  }

  /** Pixels of which the world shows more than one thing may differ: rounding decides there. */
  private static void rigid(Tally tally) {
    Dice dice = new Dice(10);
    Scene here =
        moved(
            new SampleWorld(1, false, Vector3d.ZERO, SampleWorld.DULL).scene().build(),
            Transform.IDENTITY);
    double[] plain = pixels(here, 1);
    double[] smooth = pixels(here, 64);
    for (int i = 0; i < tally.times(5, 100); i++) {
      Transform turn = Transform.rotate(Quaternion.aboutAxis(dice.unit(), dice.in(0, 360)));
      double[] there = pixels(moved(here, turn.then(Transform.translate(dice.cube(10)))), 1);
      double squares = 0;
      int count = 0;
      for (int k = 0; k < plain.length; k++) {
        double off = Math.abs(there[k] - plain[k]);
        boolean edge = Math.abs(smooth[k] - plain[k]) > 1e-2;
        tally.check(off <= 1e-12 || edge);
        squares += edge ? 0 : off * off;
        count += edge ? 0 : 1;
      }
      tally.error(Math.sqrt(squares / count));
      tally.check(count > plain.length / 2);
    }
  }
}

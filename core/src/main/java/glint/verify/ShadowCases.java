package glint.verify;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Aov;
import glint.render.RenderResult;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.List;
import java.util.Set;

/** Light and shadow: at the horizon, at the lamp, at contact, and through walls. */
final class ShadowCases {

  private static final double[] SCALES = {1e-6, 1e-3, 1, 1e3, 1e6};
  private static final Rgb GREY = Rgb.grey(0.25);

  /** Gives back ambient light, is diffuse, and has a highlight. */
  private static final Material SHINY =
      new Material(Rgb.grey(0.5), Rgb.grey(0.5), Rgb.grey(0.5), 10, Rgb.BLACK, Rgb.BLACK);

  private ShadowCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("H01", "n·l = 0 exactly: nothing but ambient light", ShadowCases::horizon),
        HardCase.exact("H02", "a lamp at the hit point is skipped", ShadowCases::lampAtSurface),
        HardCase.exact("H03", "an occluder at 1+1e-12 of the lamp", t -> occluder(t, 1e-12)),
        HardCase.exact("H04", "an occluder at 1-1e-9 of the lamp", t -> occluder(t, -1e-9)),
        HardCase.exact("H05", "no convex solid shadows itself", ShadowCases::acne),
        HardCase.exact("H06", "a sealed room is dark", ShadowCases::sealedRoom),
        HardCase.exact("H07", "a sphere on a plane, next to contact", ShadowCases::contact));
  }

  private static void horizon(Tally tally) {
    Plane ground = new Plane(Vector3d.ZERO, Pictures.UP);
    for (double angle = 0; angle < 6; angle += 0.5) {
      Vector3d along = new Vector3d(StrictMath.cos(angle), 0, StrictMath.sin(angle));
      Scene.Builder scene =
          Pictures.looking(new Vector3d(0, 3, 0), new Vector3d(1, 0, 1), 60)
              .light(new Light.Ambient(GREY))
              .light(new Light.Directional(along, Rgb.WHITE))
              .place(Placement.of(ground, SHINY));
      allAre(0.125, Pictures.pixels(scene), tally);
    }
  }

  private static void allAre(double expected, double[] pixels, Tally tally) {
    for (int i = 0; i < pixels.length; i += 3) {
      tally.check(pixels[i] == expected && pixels[i + 1] == expected && pixels[i + 2] == expected);
    }
  }

  private static void lampAtSurface(Tally tally) {
    Plane ground = new Plane(Vector3d.ZERO, Pictures.UP);
    for (double scale : SCALES) {
      Vector3d eye = new Vector3d(0, scale, 0);
      for (boolean inverseSquare : new boolean[] {false, true}) {
        Scene.Builder scene =
            Pictures.looking(eye, Vector3d.ZERO, 60)
                .size(1, 1)
                .light(new Light.Ambient(GREY))
                .light(new Light.Point(Vector3d.ZERO, Rgb.WHITE, inverseSquare))
                .place(Placement.of(ground, SHINY));
        allAre(0.125, Pictures.pixels(scene), tally);
      }
    }
  }

  /** A screen just beyond the lamp leaves the point lit; just before it, in shadow. */
  private static void occluder(Tally tally, double beyond) {
    Dice dice = new Dice(3);
    Plane ground = new Plane(Vector3d.ZERO, Pictures.UP);
    for (int i = 0; i < 500; i++) {
      double scale = SCALES[i % SCALES.length];
      Vector3d to = new Vector3d(dice.in(-1, 1), dice.in(0.5, 1), dice.in(-1, 1)).times(scale);
      Vector3d p = dice.across(to).times(0.1 * scale);
      Vector3d q = to.cross(p).normalized().times(0.1 * scale);
      Vector3d screen = to.times(1 + beyond).minus(p.times(0.5)).minus(q.times(0.5));
      Vector3d eye = new Vector3d(-to.z(), 0.3 * scale, to.x());
      Scene.Builder scene =
          Pictures.looking(eye, Vector3d.ZERO, 1)
              .size(1, 1)
              .light(new Light.Point(to, Rgb.WHITE, i % 2 == 0))
              .place(Placement.of(ground, Pictures.CHALK))
              .place(Placement.of(new Quad(screen, p, q), Pictures.CHALK));
      tally.check(Pictures.pixels(scene)[0] > 0 == beyond > 0);
    }
  }

  private static void acne(Tally tally) {
    Dice dice = new Dice(5);
    Transform squash =
        Transform.scale(new Vector3d(1, 0.3, 0.05))
            .then(Transform.rotate(Quaternion.aboutAxis(new Vector3d(1, 2, 3), 50)));
    for (double scale : new double[] {1e-3, 1, 1e6}) {
      for (double away : new double[] {0, 1e3, 1e6}) {
        Vector3d middle = dice.unit().times(scale * away);
        Transform plain = Transform.scale(new Vector3d(scale, scale, scale));
        for (Surface solid : solids()) {
          lit(dice, solid, plain.then(Transform.translate(middle)), middle, scale, tally);
        }
        Transform flat = squash.then(plain).then(Transform.translate(middle));
        lit(dice, new Sphere(Vector3d.ZERO, 1), flat, middle, scale, tally);
      }
    }
  }

  private static List<Surface> solids() {
    Vector3d top = new Vector3d(0.3, 0.8, 0.2);
    return List.of(
        new Sphere(Vector3d.ZERO, 1),
        new Box(new Vector3d(-0.8, -0.3, -0.7), new Vector3d(0.5, 0.4, 0.6)),
        new Cylinder(top.negated(), top, 0.5, 0.5, true),
        new Cylinder(top.negated(), top, 0.7, 0.1, true));
  }

  private static void lit(
      Dice dice, Surface solid, Transform place, Vector3d middle, double scale, Tally tally) {
    Vector3d eye = middle.plus(dice.unit().times(4 * scale));
    Vector3d toLight = dice.unit();
    Scene.Builder scene =
        Pictures.looking(eye, middle, 35)
            .light(new Light.Directional(toLight.negated(), Rgb.WHITE))
            .place(new Placement(solid, place, Pictures.CHALK));
    RenderResult result = Pictures.render(scene.build(), Set.of(Aov.NORMAL));
    double[] n = result.aovs().get(Aov.NORMAL).rgb();
    double[] light = result.image().rgb();
    for (int i = 0; i < n.length; i += 3) {
      double cos = n[i] * toLight.x() + n[i + 1] * toLight.y() + n[i + 2] * toLight.z();
      if (cos > 1e-6) {
        tally.check(light[i] > 0);
      }
    }
  }

  private static void sealedRoom(Tally tally) {
    Dice dice = new Dice(6);
    for (int i = 0; i < 24; i++) {
      double scale = SCALES[i % SCALES.length];
      Vector3d middle = dice.unit().times(i % 2 == 0 ? 0 : 1e4 * scale);
      ClosedMesh room = ClosedMesh.cube(1).placed(scale, middle);
      Vector3d eye = middle.plus(dice.cube(0.9 * scale));
      Scene.Builder scene =
          Pictures.looking(eye, eye.plus(dice.unit()), 100)
              .light(new Light.Ambient(GREY))
              .light(new Light.Point(middle.plus(dice.unit().times(5 * scale)), Rgb.WHITE, true))
              .light(new Light.Point(middle.plus(dice.unit().times(2 * scale)), Rgb.WHITE, false))
              .light(new Light.Directional(dice.unit(), Rgb.WHITE))
              .place(Placement.of(room.surface(), SHINY));
      allAre(0.125, Pictures.pixels(scene), tally);
    }
  }

  /** The gap at a distance d from contact is d²/2r, below any rounding of a coordinate. */
  private static void contact(Tally tally) {
    Dice dice = new Dice(7);
    for (double r : SCALES) {
      Sphere ball = new Sphere(new Vector3d(0, r, 0), r);
      Shoot ground = Shoot.at(new Plane(Vector3d.ZERO, Pictures.UP));
      Shoot sphere = Shoot.at(ball);
      for (int i = 0; i < tally.times(2000, 20_000); i++) {
        double distance = dice.log(1e-9, 1e-3);
        Vector3d out = dice.across(Pictures.UP);
        Vector3d point = out.times(distance * r);
        if (ground.from(
            point.plus(out.plus(Pictures.UP).times(r)), out.plus(Pictures.UP).negated())) {
          ground.resolve();
          double rise = i % 2 == 0 ? dice.log(0.01, 10) : distance * dice.in(0, 4);
          Vector3d light = dice.across(Pictures.UP).plus(Pictures.UP.times(rise)).normalized();
          ground.hit.spawn(light.x(), light.y(), light.z(), sphere.ray);
          boolean shadowed = sphere.closest();
          List<Crossing> truth = new SphereOracle(ball).crossings(ground.point(), light);
          tally.check(
              Crossing.wrongness(
                      truth,
                      shadowed,
                      sphere.hit.t,
                      SphereOracle.PARAMETER.most(),
                      Double.POSITIVE_INFINITY)
                  <= SphereOracle.DECISION.most());
        }
      }
    }
  }
}

package glint.verify;

import glint.accel.Intersector;
import glint.color.Rgb;
import glint.geometry.CornerValues;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Ray;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.Tracer;
import java.math.BigDecimal;
import java.util.List;

/** Flat triangles that light sees as curved: their normals, terminators and mirror images. */
final class SmoothCases {

  private static final Material MIRROR =
      new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.WHITE, Rgb.BLACK);

  private SmoothCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within(
            "T16", "smooth normals have length 1", 2, "u", tally -> bentTriangles(tally, false)),
        HardCase.exact("T16-zero", "n and -n: the face's normal", SmoothCases::opposite),
        HardCase.exact(
            "H09",
            "80 triangles as a sphere: light falls off to one side",
            SmoothCases::terminator),
        HardCase.exact(
            "H10",
            "no ray mirrored or bent by a smooth normal crosses over",
            tally -> bentTriangles(tally, true)),
        HardCase.exact(
            "H10-convex", "a convex mirror of any normals shows only sky", SmoothCases::mirrors));
  }

  /** One mesh in the world, and rays at it; scratch. */
  private static final class View {

    private final Prepared scene;
    private final Intersector search;
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();

    View(Mesh mesh, Transform toWorld) {
      Placement placement = new Placement(mesh, toWorld, Pictures.CHALK);
      scene =
          Prepared.of(Pictures.looking(Pictures.UP, Vector3d.ZERO, 40).place(placement).build());
      search = scene.intersector();
    }

    boolean sees(Vector3d eye, Vector3d target) {
      Vector3d d = target.minus(eye).normalized();
      ray.set(eye.x(), eye.y(), eye.z(), d.x(), d.y(), d.z());
      search.closest(ray, Double.POSITIVE_INFINITY, hit);
      if (hit.found()) {
        search.resolve(ray, hit);
        scene.face(ray, hit);
      }
      return hit.found();
    }

    Vector3d normal() {
      return new Vector3d(hit.nx, hit.ny, hit.nz);
    }

    Vector3d shading() {
      return new Vector3d(hit.sx, hit.sy, hit.sz);
    }
  }

  private static Mesh triangle(Vector3d[] at, Vector3d[] normals) {
    int[] three = {0, 1, 2};
    Mesh flat = new Mesh(numbers(at), three);
    return flat.withNormals(new CornerValues(3, numbers(normals), three), new int[1]);
  }

  private static double[] numbers(Vector3d... v) {
    return new double[] {
      v[0].x(), v[0].y(), v[0].z(), v[1].x(), v[1].y(), v[1].z(), v[2].x(), v[2].y(), v[2].z()
    };
  }

  private static Transform somewhere(Dice dice) {
    Vector3d factors = new Vector3d(dice.log(0.01, 100), dice.log(0.01, 100), dice.log(0.01, 100));
    return Transform.scale(factors.times(dice.sign()))
        .then(Transform.rotate(Quaternion.aboutAxis(dice.unit(), dice.in(0, 360))))
        .then(Transform.translate(dice.cube(100)));
  }

  /** Tries normals that point anywhere, and some of no length. */
  private static void bentTriangles(Tally tally, boolean leaving) {
    Dice dice = new Dice(16);
    for (int i = 0; i < tally.times(2000, 50_000); i++) {
      Vector3d[] at = {dice.cube(1), dice.cube(1), dice.cube(1)};
      Vector3d[] normals = new Vector3d[3];
      for (int k = 0; k < 3; k++) {
        normals[k] = dice.unit().times(dice.below(5) == 0 ? 0 : dice.log(1e-150, 1e150));
      }
      Transform toWorld = somewhere(dice);
      View view = new View(triangle(at, normals), toWorld);
      for (int k = 0; k < 10; k++) {
        double u = dice.in(0, 1);
        double v = dice.in(0, 1 - u);
        Vector3d p = at[0].times(u).plus(at[1].times(v)).plus(at[2].times(1 - u - v));
        if (view.sees(toWorld.point(dice.cube(3)), toWorld.point(p))) {
          if (leaving) {
            leave(dice, view, tally);
          } else if (!view.shading().equals(view.normal())) {
            BigDecimal squared = Exact3.of(view.shading()).squared();
            double more = Exact.toDouble(squared.subtract(BigDecimal.ONE)) / 2;
            tally.error(Math.abs(more) / Rounding.U);
            tally.check(Double.isFinite(more));
          }
        }
      }
    }
  }

  private static void leave(Dice dice, View view, Tally tally) {
    Vector3d d = new Vector3d(view.ray.dx, view.ray.dy, view.ray.dz);
    Vector3d s = view.shading();
    Vector3d mirrored = d.minus(s.times(2 * d.dot(s)));
    view.hit.spawn(mirrored.x(), mirrored.y(), mirrored.z(), 1, view.ray);
    tally.check(rise(view) >= 0);
    double cos = -d.dot(s);
    double eta = dice.in(0.5, 2);
    double out = 1 - eta * eta * (1 - cos * cos);
    if (cos > 0 && out >= 0) {
      Vector3d bent = d.times(eta).plus(s.times(eta * cos - Math.sqrt(out)));
      view.hit.spawn(bent.x(), bent.y(), bent.z(), -1, view.ray);
      tally.check(rise(view) <= 0);
    }
  }

  /** Returns the exact sign of a leaving ray's rise over the true surface. */
  private static int rise(View view) {
    Exact3 d = Exact3.of(view.ray.dx, view.ray.dy, view.ray.dz);
    return d.dot(Exact3.of(view.normal())).signum();
  }

  private static void opposite(Tally tally) {
    Dice dice = new Dice(17);
    Vector3d[] at = {new Vector3d(-1, 0, 0), new Vector3d(1, 0, 0), new Vector3d(0, 2, 0)};
    for (int i = 0; i < 1000; i++) {
      Vector3d n = dice.unit();
      Vector3d[] normals = {n, n.negated(), dice.unit()};
      View view = new View(triangle(at, normals), Transform.IDENTITY);
      boolean seen = view.sees(new Vector3d(0, 0, dice.sign()), Vector3d.ZERO);
      tally.check(seen && view.shading().equals(view.normal()));
    }
  }

  /** Walks along great circles through the point that faces the light. */
  private static void terminator(Tally tally) {
    Dice dice = new Dice(9);
    Mesh ball = ClosedMesh.icosphere(1).round();
    for (int i = 0; i < tally.times(20, 500); i++) {
      Vector3d toLight = dice.unit();
      Scene.Builder scene =
          Pictures.looking(toLight.times(3), Vector3d.ZERO, 40)
              .light(new Light.Directional(toLight.negated(), Rgb.WHITE))
              .place(Placement.of(ball, Pictures.CHALK));
      Tracer tracer = new Tracer(Prepared.of(scene.build()), 1, 0);
      Vector3d across = dice.across(toLight);
      Ray ray = new Ray();
      double before = 1;
      for (int step = 1; step < 2000; step++) {
        double angle = StrictMath.PI * step / 2000;
        Vector3d d =
            toLight.times(-StrictMath.cos(angle)).minus(across.times(StrictMath.sin(angle)));
        ray.set(-3 * d.x(), -3 * d.y(), -3 * d.z(), d.x(), d.y(), d.z());
        tracer.trace(ray, Double.POSITIVE_INFINITY);
        tally.check(step < 1000 ? tracer.r < before && tracer.r > 0 : tracer.r <= before);
        before = tracer.r;
      }
    }
  }

  /** A mirror image traced into the mirror would be dark: the mirror gives no light. */
  private static void mirrors(Tally tally) {
    Dice dice = new Dice(10);
    for (int i = 0; i < tally.times(20, 500); i++) {
      Mesh flat = ClosedMesh.icosphere(dice.below(3)).surface();
      double[] normals = new double[9 * flat.triangles()];
      int[] each = new int[3 * flat.triangles()];
      for (int k = 0; k < each.length; k++) {
        Vector3d n = dice.unit();
        normals[3 * k] = n.x();
        normals[3 * k + 1] = n.y();
        normals[3 * k + 2] = n.z();
        each[k] = k;
      }
      Mesh bent = flat.withNormals(new CornerValues(3, normals, each), new int[flat.triangles()]);
      Scene.Builder scene =
          Pictures.looking(dice.unit().times(3), Vector3d.ZERO, 50)
              .background(Background.constant(Rgb.WHITE))
              .place(Placement.of(bent, MIRROR));
      for (double v : Pictures.pixels(scene)) {
        tally.check(v == 1);
      }
    }
  }
}

package glint.fuzz;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.PreparedFacts;
import glint.scene.RenderPlan;
import glint.scene.Scene;
import glint.scene.View;
import glint.trace.Tracer;
import java.util.OptionalInt;
import java.util.Set;

/** Tries random scenes: what must hold of each, and how much was seen of them. */
final class Trial {

  /** To within this a unit vector has length 1, and a radiance keeps its bound. */
  private static final double ROUNDING = 1e-9;

  /** One scene in so many is rendered as the command would, with a pool of threads. */
  private static final int RENDERED = 64;

  /** Rays whose closest hit was searched, and how many found one. */
  long rays;

  long hits;

  /** Rays from hits to lights. */
  long shadowRays;

  private final Ray ray = new Ray();
  private final Hit found = new Hit();
  private final Hit other = new Hit();

  private Intersector scan;
  private Intersector tree;
  private double radianceBound;
  private Tracer everything;
  private Tracer needed;

  /** Throws an error unless everything holds. */
  void run(FuzzScene fuzz) {
    Scene scene = fuzz.scene();
    Prepared withTree = Prepared.of(scene, RenderPlan.everything());
    Prepared prepared = Prepared.of(scene);
    int depth = scene.maxDepth().orElse(RenderSettings.DEFAULT_DEPTH);
    radianceBound = Math.min(prepared.radianceBound() * (1 + ROUNDING), Double.MAX_VALUE);
    everything = new Tracer(withTree, depth, 1e-4);
    needed = new Tracer(prepared, depth, 1e-4);
    scan = PreparedFacts.scan(withTree);
    tree = withTree.intersector();
    for (FuzzScene.Segment segment : fuzz.rays()) {
      follow(segment);
    }
    View view = new View(scene.camera(), scene.width(), scene.height());
    look(view, 0.5 * scene.width(), 0.5 * scene.height());
    look(view, 0.5, scene.height() - 0.5);
    shadowRays += everything.counts().shadow;
    if (fuzz.seed() % RENDERED == 0) {
      render(prepared);
    }
  }

  /** Tries a ray that ends before the segment does, as shadow rays do, and one that does not. */
  private void follow(FuzzScene.Segment segment) {
    Vector3d o = segment.from();
    Vector3d d = segment.to().minus(o);
    if (d.maxAbs() > 0) {
      int exponent = Math.getExponent(d.maxAbs());
      double x = Math.scalb(d.x(), -exponent);
      double y = Math.scalb(d.y(), -exponent);
      double z = Math.scalb(d.z(), -exponent);
      ray.set(o.x(), o.y(), o.z(), x, y, z);
      search(Math.scalb(1 - 0x1p-53, exponent));
      d = d.normalized();
    } else {
      d = new Vector3d(0, -1, 0);
    }
    ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    shoot(Double.POSITIVE_INFINITY);
  }

  private void look(View view, double x, double y) {
    double end = view.ray(x, y, ray);
    if (!(ray.tMin >= 0 && ray.tMin <= end)) {
      throw failure("the camera's ray ends at " + end);
    }
    if (!isUnit(ray.dx, ray.dy, ray.dz)) {
      throw failure("the camera's ray has no unit direction");
    }
    shoot(end);
  }

  /** Searches and traces a ray; what the plan leaves out must not matter. */
  private void shoot(double end) {
    double tMin = ray.tMin;
    double[] six = {ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz};
    search(end);
    trace(everything, six, tMin, end);
    trace(needed, six, tMin, end);
    if (!(everything.r == needed.r && everything.g == needed.g && everything.b == needed.b)) {
      throw failure("with everything on " + radiance(everything) + ", else " + radiance(needed));
    }
  }

  private void trace(Tracer tracer, double[] six, double tMin, double end) {
    ray.set(six[0], six[1], six[2], six[3], six[4], six[5]);
    ray.tMin = tMin;
    tracer.trace(ray, end);
    if (!(isRadiance(tracer.r) && isRadiance(tracer.g) && isRadiance(tracer.b))) {
      ray.set(six[0], six[1], six[2], six[3], six[4], six[5]);
      throw failure("radiance " + radiance(tracer) + ", where the bound is " + radianceBound);
    }
  }

  private boolean isRadiance(double v) {
    return v >= 0 && v <= radianceBound;
  }

  private static String radiance(Tracer tracer) {
    return "(" + tracer.r + ", " + tracer.g + ", " + tracer.b + ")";
  }

  /** Compares tree and scan, and looks at the hit. */
  private void search(double end) {
    rays++;
    scan.closest(ray, end, found);
    tree.closest(ray, end, other);
    if (!(other.t == found.t && other.primitive == found.primitive)) {
      throw failure("tree: " + name(other) + ", scan: " + name(found));
    }
    if (tree.any(ray, end, other) != found.found()) {
      throw failure("any hit differs from the closest: " + name(found));
    }
    if (found.found()) {
      hits++;
      resolve(end);
    }
  }

  private void resolve(double end) {
    if (!(found.t > ray.tMin && found.t <= end && found.t < Double.POSITIVE_INFINITY)) {
      throw failure("out of range: " + name(found));
    }
    if (!tree.any(ray, found.t, other) || tree.any(ray, Math.nextDown(found.t), other)) {
      throw failure("any hit does not begin with the closest: " + name(found));
    }
    scan.resolve(ray, found);
    if (!Double.isFinite(found.px + found.py + found.pz)) {
      throw failure("hit at (" + found.px + ", " + found.py + ", " + found.pz + ")");
    }
    if (!isUnit(found.nx, found.ny, found.nz)) {
      throw failure("normal (" + found.nx + ", " + found.ny + ", " + found.nz + ")");
    }
  }

  private static boolean isUnit(double x, double y, double z) {
    return Math.abs(Math.sqrt(x * x + y * y + z * z) - 1) < ROUNDING;
  }

  private static String name(Hit hit) {
    return hit.found() ? "primitive " + hit.primitive + " at t = " + hit.t : "nothing";
  }

  private AssertionError failure(String what) {
    String origin = "(" + ray.ox + ", " + ray.oy + ", " + ray.oz + ")";
    String direction = "(" + ray.dx + ", " + ray.dy + ", " + ray.dz + ")";
    return new AssertionError(
        what + "\nray from " + origin + " along " + direction + " after t = " + ray.tMin);
  }

  private static void render(Prepared scene) {
    RenderSettings settings = new RenderSettings(2, 2, 1, 0, OptionalInt.empty(), 1, 32, Set.of());
    RenderResult result = new Renderer(scene, settings).render(Progress.NONE);
    if (result.statistics().invalid() != 0) {
      throw new AssertionError("invalid samples: " + result.statistics().invalid());
    }
    for (double v : result.image().rgb()) {
      if (!(v >= 0 && v < Double.POSITIVE_INFINITY)) {
        throw new AssertionError("film: " + v);
      }
    }
  }
}

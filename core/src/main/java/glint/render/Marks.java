package glint.render;

import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Outline;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.View;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Where every second corner is too few to tell what lies between: something may be seen there that
 * covers none of them.
 *
 * <p>Things are found by projection, like {@link SmallThings}, and so are their shadows. What need
 * not be convex may be thin anywhere. The shadow of something narrow may fall on anything on its
 * way.
 */
final class Marks {

  /** The distance of the corners that are looked at. */
  static final int STEP = 2;

  /** What is so narrow, in steps, may cover no corner though its outline, a little wider, does. */
  private static final double NARROW = 2;

  /** The shadow of what is less wide, in pixels, may be narrow wherever it falls. */
  private static final double NARROW_CASTER = 8;

  /** One looks through a tube at most this many times as oblique as its radius by its length. */
  private static final double THROUGH = 4;

  /** So near to a light, in pixels, its light may vary at once. */
  private static final double BESIDE_LIGHT = 8;

  /** Up to a distance of so many pixels shadows are followed. */
  private static final double FAR = 0x1p16;

  /** What holds a shadow, and whether it may be narrow anywhere in there. */
  private record Shadow(List<Vector3d> outline, boolean narrow) {}

  private final Prepared scene;
  private final View view;
  private final Silhouette silhouette;
  private final ConvexPolygon whole;
  private final Glimpses cells;
  private final List<Shadow> shadows = new ArrayList<>();
  private final List<Vector3d> places = new ArrayList<>();

  /** Squares in a row. */
  private final int columns;

  private final boolean[] marked;

  /**
   * Marks what may be seen.
   *
   * @param shown to where mirrors seem to move what they show, for each of those looked into
   */
  Marks(Prepared scene, View view, CornerGrid corners, List<Transform> shown) {
    this.scene = scene;
    this.view = view;
    silhouette = new Silhouette(view);
    whole = silhouette.whole;
    int across = corners.stride / STEP;
    int down = corners.rows / STEP;
    cells = new Glimpses(across, down);
    columns = across;
    marked = new boolean[across * down];
    if (!shown.isEmpty()) {
      findShadows();
      shown.forEach(this::add);
    }
  }

  /** Returns how many outlines are projected for what is seen directly, or by any mirrors. */
  static long outlines(Prepared scene) {
    long lights = scene.lights().count() - scene.lights().lamps();
    return (1 + lights) * scene.scene().placements().size();
  }

  /** Returns whether a square between four of the corners that are looked at is marked. */
  boolean at(int column, int row) {
    return marked[row * columns + column];
  }

  private void findShadows() {
    CastShadow cast = new CastShadow(scene, view.eye());
    for (int light = 0; light < scene.lights().count(); light++) {
      if (scene.lights().shape(light) != null) {
        continue;
      }
      if (!scene.lights().isFar(light)) {
        places.add(view.eye().minus(scene.lights().way(light, view.eye())));
      }
      int i = light;
      int surface = 0;
      for (Placement p : scene.scene().placements()) {
        List<Vector3d> caster = p.surface() instanceof Mesh m ? box(m, p.toWorld()) : List.of();
        List<Vector3d> fallen = List.of();
        if (caster.isEmpty()) {
          fallen = cast.of(p, surface, light);
          caster = cast.caster();
        }
        if (isHollow(p.surface(), p.toWorld(), at -> scene.lights().way(i, at))
            || isNarrow(caster, light)) {
          shadows.add(new Shadow(far(caster, light), true));
        } else if (!fallen.isEmpty()) {
          shadows.add(new Shadow(fallen, false));
        }
        surface += p.materials().size();
      }
    }
  }

  /** Returns whether a light sees something so narrow that its shadow may be narrow as well. */
  private boolean isNarrow(List<Vector3d> caster, int light) {
    if (caster.isEmpty()) {
      return false;
    }
    Vector3d middle = CastShadow.middle(caster);
    Vector3d n = scene.lights().way(light, middle).normalized();
    boolean upright = Math.abs(n.z()) > Math.abs(n.x());
    Vector3d u = n.cross(upright ? new Vector3d(1, 0, 0) : new Vector3d(0, 0, 1)).normalized();
    Vector3d v = n.cross(u);
    whole.clear();
    for (Vector3d p : caster) {
      whole.add(u.dot(p.minus(middle)), v.dot(p.minus(middle)));
    }
    whole.close();
    return whole.width() < NARROW_CASTER * view.pixel(middle);
  }

  /** Returns what holds a shadow, whatever it falls on. */
  private List<Vector3d> far(List<Vector3d> caster, int light) {
    List<Vector3d> far = new ArrayList<>(caster);
    for (Vector3d p : caster) {
      double reach = FAR * view.pixel(p);
      far.add(p.plus(scene.lights().way(light, p).normalized().times(reach)));
    }
    return far;
  }

  /**
   * Returns whether something is not convex, or one may look through it.
   *
   * @param way the way to a place from where one looks
   */
  private static boolean isHollow(Surface shape, Transform toWorld, UnaryOperator<Vector3d> way) {
    if (shape instanceof Cylinder c && !c.capped()) {
      Vector3d axis = c.top().minus(c.base());
      Vector3d look = toWorld.inverted().direction(way.apply(toWorld.point(c.base())));
      double radius = Math.max(c.radius(), c.topRadius());
      return axis.cross(look).length() < THROUGH * radius * Math.abs(axis.normalized().dot(look));
    }
    return shape instanceof Mesh;
  }

  private static List<Vector3d> box(Mesh mesh, Transform toWorld) {
    List<Vector3d> points = new ArrayList<>(mesh.corners());
    points.replaceAll(toWorld::point);
    return points;
  }

  /**
   * Marks what may be seen, perhaps in mirrors.
   *
   * @param mirrored to where the mirrors seem to move what they show
   */
  private void add(Transform mirrored) {
    for (Placement p : scene.scene().placements()) {
      Transform seen = p.toWorld().then(mirrored);
      boolean hollow = isHollow(p.surface(), seen, at -> at.minus(view.eye()));
      List<Vector3d> outline =
          p.surface() instanceof Mesh mesh
              ? box(mesh, seen)
              : Outline.of(p.surface(), seen, view.eye());
      mark(outline, Transform.IDENTITY, hollow);
    }
    for (int i = 0; i < scene.lights().count(); i++) {
      if (scene.lights().shape(i) != null) {
        mark(Outline.of(scene.lights().shape(i), mirrored, view.eye()), Transform.IDENTITY, false);
      }
    }
    for (Shadow each : shadows) {
      add(each, mirrored);
    }
    for (Vector3d place : places) {
      beside(mirrored.point(place));
    }
  }

  private void add(Shadow shadow, Transform mirrored) {
    mark(shadow.outline, mirrored, shadow.narrow);
  }

  private void beside(Vector3d place) {
    silhouette.project(List.of(place));
    if (whole.count() == 1) {
      double x = whole.least(false);
      double y = whole.least(true);
      for (int i = 0; i < 4; i++) {
        whole.add(
            x + (i % 2 == 0 ? -BESIDE_LIGHT : BESIDE_LIGHT),
            y + (i < 2 ? -BESIDE_LIGHT : BESIDE_LIGHT));
      }
      whole.close();
      mark(true);
    }
  }

  private void project(List<Vector3d> points, Transform mirrored) {
    List<Vector3d> moved = new ArrayList<>(points);
    moved.replaceAll(mirrored::point);
    silhouette.project(moved);
    whole.close();
  }

  private void mark(List<Vector3d> points, Transform mirrored, boolean all) {
    if (!points.isEmpty()) {
      project(points, mirrored);
      mark(all);
    }
  }

  private void mark(boolean all) {
    whole.scale(1.0 / STEP);
    cells.visit(whole, all || whole.width() < NARROW, this::mark);
  }

  private void mark(int x, int y) {
    marked[y * columns + x] = true;
  }
}

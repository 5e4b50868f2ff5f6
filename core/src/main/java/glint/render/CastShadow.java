package glint.render;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Outline;
import glint.geometry.Ray;
import glint.light.Illumination;
import glint.math.Vector3d;
import glint.scene.Placement;
import glint.scene.Prepared;
import java.util.ArrayList;
import java.util.List;

/** Finds where the shadows of convex surfaces fall; owns the scratch for it. */
final class CastShadow {

  /** How many times its size a light of parallel rays is away from a surface. */
  private static final double FAR = 0x1p20;

  private final Illumination lights;
  private final Intersector intersector;
  private final Vector3d eye;
  private final Ray ray = new Ray();
  private final Hit hit = new Hit();

  /** What the last light looked for saw of what casts the shadow. */
  private List<Vector3d> caster = List.of();

  /**
   * Looks for shadows in a scene.
   *
   * @param eye from where it is seen
   */
  CastShadow(Prepared scene, Vector3d eye) {
    this.eye = eye;
    lights = scene.lights();
    intersector = scene.intersector();
  }

  /**
   * Returns the outline of a shadow, in the world, if what it falls on is as flat as around its
   * middle; none if it falls on nothing.
   *
   * @param surface the number of what casts it, which is not a mesh
   * @param light the number of a light without an area
   */
  List<Vector3d> of(Placement p, int surface, int light) {
    Vector3d way = lights.way(light, eye);
    boolean far = lights.isFar(light);
    List<Vector3d> outline = Outline.of(p.surface(), p.toWorld(), far ? eye : eye.minus(way));
    if (!outline.isEmpty() && far) {
      Vector3d middle = middle(outline);
      double size = outline.get(0).minus(middle).maxAbs();
      outline = Outline.of(p.surface(), p.toWorld(), middle.minus(way.times(FAR * size)));
    }
    caster = outline;
    return outline.isEmpty() || !falls(middle(outline), surface, light)
        ? List.of()
        : onto(outline, light);
  }

  /** Returns what the last light asked for sees of what may cast a shadow, in the world. */
  List<Vector3d> caster() {
    return caster;
  }

  /** Returns the number of the surface that the last shadow found falls onto. */
  int fallsOnto() {
    return hit.surface;
  }

  static Vector3d middle(List<Vector3d> points) {
    Vector3d sum = Vector3d.ZERO;
    for (Vector3d p : points) {
      sum = sum.plus(p);
    }
    return sum.times(1.0 / points.size());
  }

  /** Finds what lies behind a place in a surface, as a light sees it; returns whether anything. */
  private boolean falls(Vector3d place, int surface, int light) {
    Vector3d way = lights.way(light, place);
    ray.set(place.x(), place.y(), place.z(), way.x(), way.y(), way.z());
    ray.time = 0.5;
    while (true) {
      intersector.closest(ray, Double.POSITIVE_INFINITY, hit);
      if (!hit.found()) {
        return false;
      }
      intersector.resolve(ray, hit);
      if (hit.surface != surface) {
        return true;
      }
      ray.goOnAfter(hit);
    }
  }

  /** Moves points along the light to the plane that touches the hit. */
  private List<Vector3d> onto(List<Vector3d> points, int light) {
    Vector3d normal = new Vector3d(hit.nx, hit.ny, hit.nz);
    Vector3d place = new Vector3d(hit.px, hit.py, hit.pz);
    double facing = normal.dot(lights.way(light, place));
    List<Vector3d> moved = new ArrayList<>();
    for (Vector3d p : points) {
      Vector3d way = lights.way(light, p);
      double towards = normal.dot(way);
      double s = normal.dot(place.minus(p)) / towards; // less than 0 where it stands in the plane
      if (!(facing * towards > 0 && Math.abs(s) < Double.POSITIVE_INFINITY)) {
        return List.of();
      }
      moved.add(p.plus(way.times(s)));
    }
    return moved;
  }
}

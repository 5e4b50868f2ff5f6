package glint.verify;

import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;

/** Rays at surfaces, with or without a tree; scratch for one case. */
final class Shoot {

  final Ray ray = new Ray();
  final Hit hit = new Hit();
  private final Hit other = new Hit();
  private final Intersector search;

  private Shoot(Intersector search) {
    this.search = search;
  }

  /** Tries the surfaces one by one, each under its place in the list. */
  static Shoot at(Surface... surfaces) {
    return new Shoot(new Intersector(primitives(List.of(surfaces))));
  }

  /** Tries one surface at a place in the world. */
  static Shoot at(Surface surface, Transform toWorld) {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(surface, toWorld, 0);
    return new Shoot(new Intersector(builder.build()));
  }

  /** Tries all primitives one by one. */
  static Shoot scanning(Primitives primitives) {
    return new Shoot(new Intersector(primitives));
  }

  /** Tries what a tree over all primitives finds. */
  static Shoot throughTree(Primitives primitives) {
    return through(Bvh.over(primitives));
  }

  /** Tries what a tree finds. */
  static Shoot through(Bvh tree) {
    return new Shoot(new Intersector(tree));
  }

  static Primitives primitives(List<? extends Surface> surfaces) {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < surfaces.size(); i++) {
      builder.add(surfaces.get(i), Transform.IDENTITY, i);
    }
    return builder.build();
  }

  /** Sends a ray; returns whether it hits. */
  boolean from(Vector3d o, Vector3d d) {
    ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
    return closest();
  }

  /** Sends a ray through a point; returns whether it hits. */
  boolean through(Vector3d o, Vector3d target) {
    return from(o, target.minus(o));
  }

  /** Sends the ray as it is now; returns whether it hits. */
  boolean closest() {
    search.closest(ray, Double.POSITIVE_INFINITY, hit);
    return hit.found();
  }

  /** Returns whether the ray as it is now hits anything up to a parameter. */
  boolean any(double tMax) {
    return search.any(ray, tMax, other);
  }

  /** Returns how many nodes of a tree were looked at so far. */
  long nodesVisited() {
    return search.nodesVisited();
  }

  /** Fills in point and normal of the hit. */
  void resolve() {
    search.resolve(ray, hit);
  }

  /** Makes the ray leave the resolved hit; returns whether it hits again. */
  boolean leave(Vector3d d) {
    hit.spawn(d.x(), d.y(), d.z(), ray);
    return closest();
  }

  Vector3d origin() {
    return new Vector3d(ray.ox, ray.oy, ray.oz);
  }

  Vector3d direction() {
    return new Vector3d(ray.dx, ray.dy, ray.dz);
  }

  Vector3d point() {
    return new Vector3d(hit.px, hit.py, hit.pz);
  }

  Vector3d normal() {
    return new Vector3d(hit.nx, hit.ny, hit.nz);
  }
}

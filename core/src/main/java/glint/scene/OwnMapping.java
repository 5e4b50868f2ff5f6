package glint.scene;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.math.Vector3d;
import glint.optics.Around;
import glint.optics.Faces;
import glint.optics.Flat;
import glint.optics.Mapping;
import glint.optics.Planar;
import glint.optics.Spherical;

/** How an image lies on each kind of surface if nobody says so. */
final class OwnMapping {

  private OwnMapping() {}

  /** Returns the mapping, or null for a mesh, whose corners have points of their own. */
  static Mapping of(Surface surface) {
    if (surface instanceof Mesh) {
      return null;
    } else if (surface instanceof Sphere s) {
      return Spherical.around(s.center());
    } else if (surface instanceof Quad q) {
      return Planar.along(q.corner(), q.edge1(), q.edge2());
    } else if (surface instanceof Triangle t) {
      return onTriangle(t);
    } else if (surface instanceof Box b) {
      return new Faces(b.min(), b.max());
    } else if (surface instanceof Cylinder c) {
      return Around.of(c.base(), c.top().minus(c.base()), c.radius(), c.topRadius());
    }
    return new Flat(); // planes and pyramids
  }

  /** One without area is never hit. */
  private static Mapping onTriangle(Triangle t) {
    Vector3d edge1 = t.b().minus(t.a());
    Vector3d edge2 = t.c().minus(t.a());
    boolean isLine = edge1.maxAbs() == 0 || edge2.maxAbs() == 0;
    isLine = isLine || edge1.normalized().cross(edge2.normalized()).maxAbs() == 0;
    return isLine ? new Flat() : Planar.along(t.a(), edge1, edge2);
  }
}

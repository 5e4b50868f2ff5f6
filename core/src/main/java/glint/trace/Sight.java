package glint.trace;

import glint.geometry.Hit;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Material;

/**
 * How the eye sees what a camera ray and its mirror images have met; scratch.
 *
 * <p>A sight is plain if everything on the way is opaque, and either flat without an image or dull
 * and of one colour: then light varies slowly over it, and flat mirrors show things as they are, at
 * another place.
 */
public final class Sight {

  /** The most mirrors of a plain sight. */
  private static final int MOST = 3;

  private final Signature mirrors = new Signature();
  private final Vector3d[] points = new Vector3d[MOST];
  private final Vector3d[] normals = new Vector3d[MOST];
  private int count;
  private boolean plain;
  private boolean dull;

  void clear() {
    mirrors.clear();
    count = 0;
    plain = true;
    dull = true;
  }

  /** Adds what a ray has met. */
  void meet(Hit hit, Material material) {
    boolean smooth = hit.sx != hit.nx || hit.sy != hit.ny || hit.sz != hit.nz;
    if (hit.curved || smooth) {
      plain &= material.specular().isBlack() && material.reflection().isBlack();
      plain &= !material.texture().isPresent();
    }
    dull &= material.specular().isBlack();
    plain &= !material.isTransparent();
    plain &= !(material.texture().orElse(null) instanceof ImageTexture);
  }

  /** Adds a mirror, which a ray has met before. */
  void reflect(Hit hit, int surface) {
    if (count == MOST) {
      plain = false;
      return;
    }
    points[count] = new Vector3d(hit.px, hit.py, hit.pz);
    normals[count] = new Vector3d(hit.nx, hit.ny, hit.nz);
    mirrors.add(hit, surface);
    count++;
  }

  /** Returns whether the last ray saw nothing but what is plain. */
  public boolean isPlain() {
    return plain;
  }

  /** Returns whether nothing of that has highlights. */
  public boolean isDull() {
    return dull;
  }

  /** Returns by which mirrors it did, in one number; 0 if by none. */
  public long mirrors() {
    return mirrors.value();
  }

  /** Returns by how many mirrors that was. */
  public int count() {
    return count;
  }

  /** Returns to where the first so many mirrors together seem to move what they show. */
  public Transform moved(int mirrors) {
    Transform moved = Transform.IDENTITY;
    for (int i = 0; i < mirrors; i++) {
      moved = mirrored(points[i], normals[i]).then(moved);
    }
    return moved;
  }

  /** Returns the mirror image of the world about a plane. */
  private static Transform mirrored(Vector3d point, Vector3d n) {
    double twice = 2 * n.dot(point);
    return Transform.matrix(
        1 - 2 * n.x() * n.x(),
        -2 * n.x() * n.y(),
        -2 * n.x() * n.z(),
        twice * n.x(),
        -2 * n.y() * n.x(),
        1 - 2 * n.y() * n.y(),
        -2 * n.y() * n.z(),
        twice * n.y(),
        -2 * n.z() * n.x(),
        -2 * n.z() * n.y(),
        1 - 2 * n.z() * n.z(),
        twice * n.z());
  }
}

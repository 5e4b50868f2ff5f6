package glint.models.shape;

import glint.math.Transform;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;

/**
 * A surface of polygons; immutable.
 *
 * @param faces indices of points, counter-clockwise as seen from outside
 */
public record Shape(List<Vector3d> points, List<int[]> faces) {

  /** Copies both lists. */
  public Shape {
    points = List.copyOf(points);
    faces = List.copyOf(faces);
  }

  /** Returns all of these surfaces as one. */
  public static Shape of(List<Shape> shapes) {
    List<Vector3d> points = new ArrayList<>();
    List<int[]> faces = new ArrayList<>();
    for (Shape shape : shapes) {
      int offset = points.size();
      points.addAll(shape.points);
      for (int[] face : shape.faces) {
        int[] moved = new int[face.length];
        for (int i = 0; i < face.length; i++) {
          moved[i] = face[i] + offset;
        }
        faces.add(moved);
      }
    }
    return new Shape(points, faces);
  }

  /** Returns this surface and another as one. */
  public Shape plus(Shape other) {
    return of(List.of(this, other));
  }

  /** Returns the surface with every point moved; a map that mirrors turns it inside out. */
  public Shape mapped(UnaryOperator<Vector3d> map) {
    List<Vector3d> moved = new ArrayList<>();
    points.forEach(p -> moved.add(map.apply(p)));
    return new Shape(moved, faces);
  }

  /** Returns the image under a transform; its outside stays outside. */
  public Shape moved(Transform transform) {
    Shape moved = mapped(transform::point);
    return transform.mirrors() ? moved.reversed() : moved;
  }

  /** Returns the surface moved by a vector. */
  public Shape moved(double x, double y, double z) {
    return moved(Transform.translate(new Vector3d(x, y, z)));
  }

  /** Returns this surface and its mirror image at the plane x = 0. */
  public Shape withMirrorImage() {
    return plus(moved(Transform.scale(new Vector3d(-1, 1, 1))));
  }

  /** Returns the surface with its outside inside. */
  public Shape reversed() {
    List<int[]> reversed = new ArrayList<>();
    for (int[] face : faces) {
      int[] back = new int[face.length];
      for (int i = 0; i < face.length; i++) {
        back[i] = face[face.length - 1 - i];
      }
      reversed.add(back);
    }
    return new Shape(points, reversed);
  }

  /** Returns the faces whose middle is as wanted, with the points that they need. */
  public Shape where(Predicate<Vector3d> wanted) {
    int[] numbers = new int[points.size()];
    List<Vector3d> kept = new ArrayList<>();
    List<int[]> chosen = new ArrayList<>();
    for (int[] face : faces) {
      if (wanted.test(middle(face))) {
        int[] renumbered = new int[face.length];
        for (int i = 0; i < face.length; i++) {
          if (numbers[face[i]] == 0) {
            kept.add(points.get(face[i]));
            numbers[face[i]] = kept.size();
          }
          renumbered[i] = numbers[face[i]] - 1;
        }
        chosen.add(renumbered);
      }
    }
    return new Shape(kept, chosen);
  }

  private Vector3d middle(int[] face) {
    Vector3d sum = Vector3d.ZERO;
    for (int corner : face) {
      sum = sum.plus(points.get(corner));
    }
    return sum.times(1.0 / face.length);
  }
}

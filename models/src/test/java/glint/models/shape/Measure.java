package glint.models.shape;

import glint.math.Vector3d;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What a surface is like as a whole. */
public final class Measure {

  private Measure() {}

  /** Returns the volume inside of a closed surface, negative if it is inside out. */
  public static double volume(Shape shape) {
    double six = 0;
    for (int[] face : shape.faces()) {
      for (int i = 2; i < face.length; i++) {
        Vector3d a = shape.points().get(face[0]);
        Vector3d b = shape.points().get(face[i - 1]);
        Vector3d c = shape.points().get(face[i]);
        six += a.dot(b.cross(c));
      }
    }
    return six / 6;
  }

  /** Returns the area of a surface of flat faces. */
  public static double area(Shape shape) {
    double area = 0;
    for (int[] face : shape.faces()) {
      Vector3d sum = Vector3d.ZERO;
      List<Vector3d> points = shape.points();
      for (int i = 0; i < face.length; i++) {
        sum = sum.plus(points.get(face[i]).cross(points.get(face[(i + 1) % face.length])));
      }
      area += sum.length() / 2;
    }
    return area;
  }

  /** Returns whether faces run along every edge as often one way as the other. */
  public static boolean isClosed(Shape shape) {
    Map<List<Integer>, Integer> balance = new HashMap<>();
    for (int[] face : shape.faces()) {
      for (int i = 0; i < face.length; i++) {
        int a = face[i];
        int b = face[(i + 1) % face.length];
        balance.merge(List.of(Math.min(a, b), Math.max(a, b)), a < b ? 1 : -1, Integer::sum);
      }
    }
    return balance.values().stream().allMatch(n -> n == 0);
  }

  /** Returns points − edges + faces: 2 for what is like a ball, 0 for a ring. */
  public static int euler(Shape shape) {
    Map<List<Integer>, Integer> edges = new HashMap<>();
    for (int[] face : shape.faces()) {
      for (int i = 0; i < face.length; i++) {
        int a = face[i];
        int b = face[(i + 1) % face.length];
        edges.put(List.of(Math.min(a, b), Math.max(a, b)), 1);
      }
    }
    return shape.points().size() - edges.size() + shape.faces().size();
  }
}

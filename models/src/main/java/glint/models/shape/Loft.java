package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;

/**
 * Surfaces through rows of points.
 *
 * <p>Rows have equally many points. Seen from outside, with the rows one above the other, points
 * run from left to right.
 */
public final class Loft {

  private final List<Vector3d> points = new ArrayList<>();
  private final List<int[]> faces = new ArrayList<>();
  private final int width;

  private Loft(List<List<Vector3d>> rows, boolean closed) {
    width = rows.get(0).size();
    for (List<Vector3d> row : rows) {
      if (row.size() != width) {
        throw new IllegalArgumentException("rows of " + width + " and of " + row.size());
      }
      points.addAll(row);
    }
    int across = closed ? width : width - 1;
    for (int row = 0; row + 1 < rows.size(); row++) {
      for (int i = 0; i < across; i++) {
        int next = (i + 1) % width;
        int low = row * width;
        faces.add(new int[] {low + i, low + next, low + width + next, low + width + i});
      }
    }
  }

  /** Returns the sheet through rows that are open. */
  public static Shape sheet(List<List<Vector3d>> rows) {
    Loft loft = new Loft(rows, false);
    return new Shape(loft.points, loft.faces);
  }

  /** Returns the tube through rows that are closed, without ends. */
  public static Shape tube(List<List<Vector3d>> rows) {
    Loft loft = new Loft(rows, true);
    return new Shape(loft.points, loft.faces);
  }

  /** Returns the body through rows that are closed, with a fan around a point at either end. */
  public static Shape body(Vector3d start, List<List<Vector3d>> rows, Vector3d end) {
    Loft loft = new Loft(rows, true);
    loft.fan(start, 0, true);
    loft.fan(end, (rows.size() - 1) * loft.width, false);
    return new Shape(loft.points, loft.faces);
  }

  private void fan(Vector3d tip, int first, boolean below) {
    int number = points.size();
    points.add(tip);
    for (int i = 0; i < width; i++) {
      int a = first + i;
      int b = first + (i + 1) % width;
      faces.add(below ? new int[] {number, b, a} : new int[] {number, a, b});
    }
  }
}

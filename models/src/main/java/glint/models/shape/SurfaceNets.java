package glint.models.shape;

import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The surface of a {@link Solid} as quadrilaterals.
 *
 * <p>Every cell of a grid that the surface passes through gets a point, every edge of the grid that
 * it crosses a face of the four cells around it (S. Gibson, Constrained Elastic Surface Nets,
 * 1998). The points are then moved onto the surface along its gradient.
 */
public final class SurfaceNets {

  private static final int NEWTON_STEPS = 4;

  private final Solid solid;
  private final Vector3d low;
  private final double cell;
  private final int[] count;
  private final double[] values;
  private final int[] numbers;
  private final List<Vector3d> points = new ArrayList<>();
  private final List<int[]> faces = new ArrayList<>();

  private SurfaceNets(Solid solid, Vector3d low, Vector3d high, double cell) {
    this.solid = solid;
    this.low = low;
    this.cell = cell;
    Vector3d extent = high.minus(low).times(1 / cell);
    count =
        new int[] {
          (int) Math.ceil(extent.x()) + 1,
          (int) Math.ceil(extent.y()) + 1,
          (int) Math.ceil(extent.z()) + 1
        };
    values = new double[count[0] * count[1] * count[2]];
    numbers = new int[values.length];
    Arrays.fill(numbers, -1);
  }

  /** Returns the surface inside of a box, in cells of an edge; the body must not reach the box. */
  public static Shape of(Solid solid, Vector3d low, Vector3d high, double cell) {
    SurfaceNets nets = new SurfaceNets(solid, low, high, cell);
    nets.evaluate();
    nets.place();
    nets.join();
    return new Shape(nets.points, nets.faces);
  }

  private void evaluate() {
    for (int i = 0; i < values.length; i++) {
      values[i] = solid.at(corner(i));
    }
  }

  private Vector3d corner(int index) {
    int x = index % count[0];
    int y = index / count[0] % count[1];
    int z = index / (count[0] * count[1]);
    return low.plus(new Vector3d(x, y, z).times(cell));
  }

  private int stride(int axis) {
    return axis == 0 ? 1 : axis == 1 ? count[0] : count[0] * count[1];
  }

  private boolean isLast(int index, int axis) {
    return index / stride(axis) % count[axis] == count[axis] - 1;
  }

  /** Gives a point to every cell with corners on both sides. */
  private void place() {
    for (int i = 0; i < values.length; i++) {
      if (isLast(i, 0) || isLast(i, 1) || isLast(i, 2)) {
        continue;
      }
      Vector3d sum = Vector3d.ZERO;
      int crossings = 0;
      for (int a = 0; a < 8; a++) {
        for (int axis = 0; axis < 3; axis++) {
          int b = a | 1 << axis;
          double from = values[offset(i, a)];
          double to = values[offset(i, b)];
          if (b != a && from < 0 != to < 0) {
            Vector3d start = corner(offset(i, a));
            Vector3d edge = corner(offset(i, b)).minus(start);
            sum = sum.plus(start.plus(edge.times(from / (from - to))));
            crossings++;
          }
        }
      }
      if (crossings > 0) {
        numbers[i] = points.size();
        points.add(ontoSurface(sum.times(1.0 / crossings)));
      }
    }
  }

  /** Returns the index of a corner of a cell; its bits say along which axes it is the upper one. */
  private int offset(int index, int corner) {
    return index
        + (corner & 1) * stride(0)
        + (corner >> 1 & 1) * stride(1)
        + (corner >> 2) * stride(2);
  }

  private Vector3d ontoSurface(Vector3d start) {
    Vector3d p = start;
    for (int i = 0; i < NEWTON_STEPS; i++) {
      double h = cell / 64;
      Vector3d slope =
          new Vector3d(
                  slope(p, new Vector3d(h, 0, 0)),
                  slope(p, new Vector3d(0, h, 0)),
                  slope(p, new Vector3d(0, 0, h)))
              .times(1 / (2 * h));
      double square = Math.max(slope.dot(slope), 0.25);
      p = p.minus(slope.times(solid.at(p) / square));
    }
    // At a sharp edge Newton's steps may lead astray.
    return p.minus(start).length() < cell / 2 ? p : start;
  }

  private double slope(Vector3d p, Vector3d step) {
    return solid.at(p.plus(step)) - solid.at(p.minus(step));
  }

  /** Makes a face around every edge of the grid with its ends on two sides. */
  private void join() {
    for (int i = 0; i < values.length; i++) {
      for (int axis = 0; axis < 3; axis++) {
        if (isLast(i, axis) || values[i] < 0 == values[i + stride(axis)] < 0) {
          continue;
        }
        int u = stride((axis + 1) % 3);
        int v = stride((axis + 2) % 3);
        int[] face = {numbers[i - u - v], numbers[i - v], numbers[i], numbers[i - u]};
        boolean inwards = values[i] >= 0;
        faces.add(inwards ? new int[] {face[3], face[2], face[1], face[0]} : face);
      }
    }
  }
}

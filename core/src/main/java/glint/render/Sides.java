package glint.render;

/**
 * The numbers of the sides between neighbouring corners, each shared by the two pixels beside it.
 *
 * <p>Horizontal sides come first: that from corner (x, y) to (x + 1, y) is number {@code y width +
 * x}. Then the vertical ones, from (x, y) to (x, y + 1).
 */
final class Sides {

  /** How many there are. */
  final int count;

  private final int width;
  private final int stride;
  private final int horizontals;

  /** By how much the numbers of a pixel's sides exceed that of its top, in the first row. */
  private final int[] beyondTop;

  Sides(CornerGrid corners) {
    stride = corners.stride;
    width = stride - 1;
    horizontals = width * corners.rows;
    beyondTop = new int[] {0, width, horizontals, horizontals + 1};
    count = horizontals + stride * (corners.rows - 1);
  }

  int top(int x, int y) {
    return y * width + x;
  }

  int left(int x, int y) {
    return horizontals + y * stride + x;
  }

  /** Returns the number of a side of a pixel: 0 top, 1 bottom, 2 left, 3 right. */
  int number(int x, int y, int side) {
    return top(x, y) + (side >> 1) * y + beyondTop[side]; // a vertical row holds one more
  }

  boolean isHorizontal(int side) {
    return side < horizontals;
  }

  /** Returns the column of the pixel below or to the right of a side; there may be none. */
  int column(int side) {
    return isHorizontal(side) ? side % width : (side - horizontals) % stride;
  }

  /** Returns the row of that pixel. */
  int row(int side) {
    return isHorizontal(side) ? side / width : (side - horizontals) / stride;
  }

  /** Returns the corner where a side begins. */
  int first(int side) {
    return row(side) * stride + column(side);
  }

  /** Returns the corner where it ends. */
  int last(int side) {
    return first(side) + (isHorizontal(side) ? 1 : stride);
  }
}

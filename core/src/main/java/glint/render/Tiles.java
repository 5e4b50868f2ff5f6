package glint.render;

/** Rectangles that cover an image, numbered row by row; immutable. */
final class Tiles {

  /** Does something for a pixel. */
  interface Visitor {
    /** Visits the pixel in column x and row y. */
    void visit(int x, int y);
  }

  private final int width;
  private final int height;
  private final int edge;
  private final int columns;
  private final int count;

  /** Cuts the image of a render into tiles. */
  Tiles(RenderSettings settings) {
    width = settings.width();
    height = settings.height();
    edge = settings.tileSize();
    columns = (width - 1) / edge + 1;
    count = Math.multiplyExact(columns, (height - 1) / edge + 1);
  }

  int width() {
    return width;
  }

  int count() {
    return count;
  }

  int beginX(int tile) {
    return tile % columns * edge;
  }

  int beginY(int tile) {
    return tile / columns * edge;
  }

  int endX(int tile) {
    return Math.min(beginX(tile) + edge, width);
  }

  int endY(int tile) {
    return Math.min(beginY(tile) + edge, height);
  }

  /** Visits the pixels of a tile row by row. */
  void forEach(int tile, Visitor visitor) {
    int left = beginX(tile);
    int right = endX(tile);
    int bottom = endY(tile);
    for (int y = beginY(tile); y < bottom; y++) {
      for (int x = left; x < right; x++) {
        visitor.visit(x, y);
      }
    }
  }
}

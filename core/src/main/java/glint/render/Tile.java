package glint.render;

/**
 * A rectangle of the image, rendered in one go.
 *
 * @param worker whose scratch to use
 * @param x0 the first column
 * @param y0 the first row
 * @param x1 the column after the last
 * @param y1 the row after the last
 */
record Tile(Renderer renderer, Worker worker, int x0, int y0, int x1, int y1) implements Runnable {

  @Override
  public void run() {
    for (int y = y0; y < y1; y++) {
      for (int x = x0; x < x1; x++) {
        worker.pixel(x, y);
      }
    }
    renderer.tileDone(worker);
  }
}

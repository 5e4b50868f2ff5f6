package glint.render;

/**
 * A rectangle of the image, rendered in one go.
 *
 * @param x0 the first column
 * @param y0 the first row
 * @param x1 the column after the last
 * @param y1 the row after the last
 */
record Tile(Renderer renderer, int x0, int y0, int x1, int y1) implements Runnable {

  @Override
  public void run() {
    Worker worker = renderer.hire();
    for (int y = y0; y < y1; y++) {
      for (int x = x0; x < x1; x++) {
        if (renderer.isCancelled()) {
          return;
        }
        worker.pixel(x, y);
      }
    }
    renderer.finish(worker);
  }
}

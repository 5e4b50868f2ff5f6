package glint.desktop.window;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;

/**
 * Where in a view a picture is shown, and how large; immutable.
 *
 * @param scale a pixel's edge, in units of the view; above 0
 * @param x where the picture's left edge is
 * @param y where the picture's upper edge is
 */
record Zoom(double scale, double x, double y) {

  private static final double LEAST = 1.0 / 64;
  private static final double MOST = 64;

  /** Returns the largest picture that fits in a view, in its middle. */
  static Zoom fit(int width, int height, int viewWidth, int viewHeight) {
    double scale = Math.min((double) viewWidth / width, (double) viewHeight / height);
    return centred(Math.max(scale, LEAST), width, height, viewWidth, viewHeight);
  }

  /** Returns a picture in the middle of a view. */
  static Zoom centred(double scale, int width, int height, int viewWidth, int viewHeight) {
    return new Zoom(
        scale,
        Math.rint((viewWidth - scale * width) / 2),
        Math.rint((viewHeight - scale * height) / 2));
  }

  /** Returns a larger or smaller picture, of which a place in the view stays where it is. */
  Zoom about(double factor, double viewX, double viewY) {
    double next = Math.max(LEAST, Math.min(MOST, scale * factor));
    double by = next / scale;
    return new Zoom(next, viewX - by * (viewX - x), viewY - by * (viewY - y));
  }

  /** Returns the picture moved in the view. */
  Zoom moved(double dx, double dy) {
    return new Zoom(scale, x + dx, y + dy);
  }

  /** Returns how many columns from the picture's left edge a place in the view is. */
  double across(double viewX) {
    return (viewX - x) / scale;
  }

  /** Returns how many rows from the picture's upper edge a place in the view is. */
  double down(double viewY) {
    return (viewY - y) / scale;
  }

  /** Returns the column at a place in the view; it may be outside of the picture. */
  int column(double viewX) {
    return (int) Math.floor(across(viewX));
  }

  /** Returns the row at a place in the view; it may be outside of the picture. */
  int row(double viewY) {
    return (int) Math.floor(down(viewY));
  }

  /** Returns where in the view a part of the picture is. */
  Rectangle2D of(Rectangle part) {
    return new Rectangle2D.Double(
        x + scale * part.x, y + scale * part.y, scale * part.width, scale * part.height);
  }
}

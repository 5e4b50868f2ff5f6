package glint.desktop.window;

import glint.render.Outlook;
import glint.render.Progress;
import glint.render.Stopwatch;
import java.awt.Rectangle;
import java.util.function.DoubleConsumer;

/** What a render has told of itself so far; thread-safe. */
final class Heard implements Progress {

  private final Stopwatch watch;
  private final Marks marks;
  private final Outlook outlook;
  private final DoubleConsumer improved;
  private boolean shown;
  private long rays;
  private double error = Double.POSITIVE_INFINITY;

  /**
   * Has heard nothing.
   *
   * @param watch tells how long the render has run
   * @param improved hears the error that is claimed for every whole picture
   */
  Heard(Stopwatch watch, Marks marks, Outlook outlook, DoubleConsumer improved) {
    this.watch = watch;
    this.marks = marks;
    this.outlook = outlook;
    this.improved = improved;
  }

  /** Returns how many rays are traced. */
  synchronized long rays() {
    return rays;
  }

  /** Returns the error that is claimed for the picture, in levels; infinite while unknown. */
  synchronized double error() {
    return error;
  }

  /** Returns whether the image shows a whole picture. */
  synchronized boolean isShown() {
    return shown;
  }

  /** The render is done, with this error. */
  synchronized void ended(double claimed) {
    error = claimed;
    shown = true;
  }

  @Override
  public synchronized void tileDone(int done, int total, long traced) {
    outlook.tiles((double) done / total, watch.seconds());
    rays = traced;
  }

  @Override
  public synchronized void traced(long count) {
    rays = count;
  }

  @Override
  public void begun(int x, int y, int endX, int endY) {
    marks.begin(new Rectangle(x, y, endX - x, endY - y));
  }

  @Override
  public void pictureImproved(double claimed, long traced) {
    if (claimed < Double.POSITIVE_INFINITY) {
      marks.whole();
      outlook.error(claimed, watch.seconds());
    }
    synchronized (this) {
      rays = traced;
      error = claimed;
      shown = true;
    }
    improved.accept(claimed);
  }
}

package glint.desktop.window;

import glint.render.Progress;
import java.awt.Rectangle;
import java.util.function.DoubleConsumer;

/** What a render has told of itself so far; thread-safe. */
final class Heard implements Progress {

  private final Clock clock;
  private final Marks marks;
  private final Outlook outlook;
  private final DoubleConsumer improved;
  private boolean shown;
  private long rays;
  private double error = Double.POSITIVE_INFINITY;

  /**
   * Has heard nothing.
   *
   * @param clock tells how long the render has run
   * @param improved hears the error that is claimed for every whole picture
   */
  Heard(Clock clock, Marks marks, Outlook outlook, DoubleConsumer improved) {
    this.clock = clock;
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
    outlook.tiles((double) done / total, clock.seconds());
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
      outlook.error(claimed, clock.seconds());
    }
    synchronized (this) {
      rays = traced;
      error = claimed;
      shown = true;
    }
    improved.accept(claimed);
  }
}

package glint.desktop.window;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Which parts of an image are in work, each by a thread, and which are finished; thread-safe. */
final class Marks {

  private final Map<Thread, Rectangle> inWork = new HashMap<>();
  private final List<Rectangle> finished = new ArrayList<>();
  private Optional<BufferedImage> before;
  private boolean whole;

  /**
   * Marks nothing.
   *
   * @param before what is shown where nothing is finished, of any size
   */
  Marks(Optional<BufferedImage> before) {
    this.before = before;
  }

  /** Shows another picture where nothing is finished, if it has more pixels than that before. */
  synchronized void show(BufferedImage picture) {
    if (before.isEmpty() || picture.getWidth() > before.get().getWidth()) {
      before = Optional.of(picture);
    }
  }

  /** Returns what is shown where nothing is finished. */
  synchronized Optional<BufferedImage> before() {
    return before;
  }

  /** This thread begins with a part, and has finished the one before. */
  synchronized void begin(Rectangle part) {
    Rectangle last = inWork.put(Thread.currentThread(), part);
    if (last != null && !whole) {
      finished.add(last);
    }
  }

  /** Every place is finished at least once. */
  synchronized void whole() {
    whole = true;
    before = Optional.empty();
    finished.clear();
  }

  /** Returns the parts that are in work. */
  synchronized List<Rectangle> inWork() {
    return List.copyOf(inWork.values());
  }

  /** Returns a picture, but with what was shown before where nothing is finished. */
  synchronized BufferedImage cover(BufferedImage picture) {
    if (before.isEmpty()) {
      return picture;
    }
    int width = picture.getWidth();
    int height = picture.getHeight();
    BufferedImage covered = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = covered.createGraphics();
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    g.drawImage(before.get(), 0, 0, width, height, null);
    for (Rectangle r : finished) {
      g.drawImage(picture.getSubimage(r.x, r.y, r.width, r.height), r.x, r.y, null);
    }
    g.dispose();
    return covered;
  }
}

package glint.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Parts of pixels in which something may be seen that no corner of theirs shows; gathered outline
 * by outline.
 */
final class Glimpses {

  /**
   * What may be seen in a part of a pixel.
   *
   * @param surface its number
   * @param shadow whether it is the shadow of that surface that may be seen
   */
  record Glimpse(int surface, boolean shadow, ConvexPolygon part) {}

  /** Decides about pixels. */
  interface Condition {
    boolean holds(int x, int y);
  }

  /** A thing at least as wide as this, in pixels, covers a corner of most pixels that it meets. */
  static final double THIN = 1;

  /** Less of a pixel is nothing. */
  private static final double LEAST_AREA = 1e-6;

  private final int width;
  private final int height;
  private final ConvexPolygon inImage = new ConvexPolygon();
  private final ConvexPolygon band = new ConvexPolygon();
  private final double[] above = new double[2];
  private final double[] below = new double[2];

  private final Map<Integer, List<Glimpse>> byPixel = new TreeMap<>();

  /** Begins without any, in an image of so many pixels. */
  Glimpses(int width, int height) {
    this.width = width;
    this.height = height;
  }

  /** Returns them by pixel, in row order. */
  Map<Integer, List<Glimpse>> byPixel() {
    return byPixel;
  }

  /**
   * Adds the parts of pixels that an outline covers, unless it covers a corner of theirs and is not
   * thin.
   *
   * @param whole the outline, closed
   * @param surface the number of what is seen
   * @param shadow whether it is the shadow of that
   * @param where in which pixels it may be seen
   */
  void add(ConvexPolygon whole, int surface, boolean shadow, Condition where) {
    visit(
        whole,
        whole.width() < THIN,
        (x, y) -> {
          if (where.holds(x, y)) {
            note(x, y, surface, shadow);
          }
        });
  }

  /**
   * Visits the pixels that an outline meets.
   *
   * @param whole the outline, closed
   * @param all whether also those of which it covers a corner
   */
  void visit(ConvexPolygon whole, boolean all, Tiles.Visitor visitor) {
    inImage.clip(whole, 0, 0, width, height);
    if (inImage.isEmpty()) {
      return;
    }
    int top = (int) inImage.least(true);
    int bottom = Math.min(height - 1, (int) inImage.greatest(true));
    for (int y = top; y <= bottom; y++) {
      band.clip(inImage, 0, y, width, y + 1);
      if (band.isEmpty()) {
        continue;
      }
      inImage.span(y, above);
      inImage.span(y + 1, below);
      int left = (int) band.least(false);
      int right = Math.min(width - 1, (int) band.greatest(false));
      for (int x = left; x <= right; x++) {
        int covered = all ? -1 : Math.max(coveredUpTo(x, above), coveredUpTo(x, below));
        if (covered >= x) {
          x = covered;
        } else {
          visitor.visit(x, y);
        }
      }
    }
  }

  /**
   * Returns the last pixel of a row up to which all have a corner on a covered part of the row's
   * upper or lower line, from one on; less if that one has none.
   */
  private static int coveredUpTo(int x, double[] span) {
    boolean left = span[0] <= x && x <= span[1];
    boolean right = span[0] <= x + 1 && x + 1 <= span[1];
    return left || right ? (int) Math.floor(span[1]) : -1;
  }

  /** Adds a part of a pixel to what may be seen of a surface there. */
  private void note(int x, int y, int surface, boolean shadow) {
    ConvexPolygon part = new ConvexPolygon();
    part.clip(band, x, y, x + 1, y + 1);
    if (part.area() < LEAST_AREA) {
      return;
    }
    List<Glimpse> here = byPixel.computeIfAbsent(y * width + x, k -> new ArrayList<>(1));
    for (Glimpse each : here) {
      if (each.surface() == surface && each.shadow() == shadow) {
        each.part().add(part);
        each.part().close();
        return;
      }
    }
    here.add(new Glimpse(surface, shadow, part));
  }
}

package glint.render;

import java.util.Arrays;
import java.util.List;

/** Looks into parts of pixels where something small may be seen; one per thread. */
final class Aim {

  /** Rays for one surface in one pixel: its outline may be wider than itself. */
  private static final int RAYS = 4;

  /** A difference to the pixel that no one needs to know of, in levels. */
  private static final double NOTHING = 1.0 / 64;

  private final CornerGrid corners;
  private final LevelScale scale;
  private final Probe probe;

  /** The radiance of the pixel as far as it is known. */
  private final double[] guess = new double[3];

  /** The variance of the corners that it begins with, in levels². */
  private double contrast;

  Aim(CornerGrid corners, LevelScale scale, Probe probe) {
    this.corners = corners;
    this.scale = scale;
    this.probe = probe;
  }

  /**
   * Returns the parts of a pixel where something is seen that matters, or null.
   *
   * @param around a variance that is to be expected of the rest of the pixel, in levels²
   */
  Focus look(int x, int y, List<Glimpses.Glimpse> glimpses, double around) {
    around(x, y, glimpses);
    contrast = Math.max(contrast, around);
    ConvexPolygon first = new ConvexPolygon();
    ConvexPolygon second = new ConvexPolygon();
    for (Glimpses.Glimpse each : glimpses) {
      if (isSeen(x, y, each)) {
        fill(each.part().area());
        ConvexPolygon part = first.isEmpty() ? first : second;
        part.add(each.part());
        part.close();
      }
    }
    double missing = first.isEmpty() ? 0 : missing(x, y);
    return missing > NOTHING * NOTHING
        ? new Focus(first, second, guess.clone(), missing, contrast)
        : null;
  }

  private boolean isSeen(int x, int y, Glimpses.Glimpse glimpse) {
    ConvexPolygon part = glimpse.part();
    for (int i = 0; i < RAYS; i++) {
      part.pick((i + 0.5) / RAYS, (0.5 + 3 * i) / RAYS % 1);
      if (probe.trace(part.px, part.py)
          && (glimpse.shadow() ? isNews(x, y) : probe.first() == glimpse.surface())) {
        return true;
      }
    }
    return false;
  }

  /** Returns whether the last ray has met what no corner of a pixel has. */
  private boolean isNews(int x, int y) {
    long[] met = corners.signature;
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    long here = probe.signature();
    return here != met[a] && here != met[a + 1] && here != met[c] && here != met[c + 1];
  }

  /** Lets the last ray's radiance fill an area of the pixel. */
  private void fill(double area) {
    guess[0] += area * (probe.r() - guess[0]);
    guess[1] += area * (probe.g() - guess[1]);
    guess[2] += area * (probe.b() - guess[2]);
  }

  /** Returns by how much the mean of a pixel's corners is off the guess: squared, in levels². */
  private double missing(int x, int y) {
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      sum += scale.squaredDifference(guess[channel], corners.mean(x, y, channel));
    }
    return sum / 3;
  }

  /** Begins with the mean of the corners of a pixel where nothing small is; of all if there is. */
  private void around(int x, int y, List<Glimpses.Glimpse> glimpses) {
    Arrays.fill(guess, 0);
    double[] squares = new double[3];
    double[] levels = new double[3];
    int count = 0;
    for (int i = 0; i < 4; i++) {
      int column = x + (i & 1);
      int row = y + (i >> 1);
      if (glimpses.stream().noneMatch(each -> each.part().contains(column, row))) {
        count++;
        for (int channel = 0; channel < 3; channel++) {
          double radiance = corners.rgb[3 * (row * corners.stride + column) + channel];
          double level = scale.level(radiance);
          guess[channel] += radiance;
          levels[channel] += level;
          squares[channel] += level * level;
        }
      }
    }
    contrast = 0;
    for (int channel = 0; channel < 3; channel++) {
      guess[channel] = count == 0 ? corners.mean(x, y, channel) : guess[channel] / count;
      double mean = levels[channel] / Math.max(1, count);
      contrast += Math.max(0, squares[channel] / Math.max(1, count) - mean * mean) / 3;
    }
  }
}

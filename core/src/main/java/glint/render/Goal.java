package glint.render;

import glint.math.Check;

/** When a render is good enough; immutable. */
public sealed interface Goal {

  /**
   * Exactly so many samples of every pixel; one is its centre.
   *
   * @param count at least 1
   */
  record Samples(int count) implements Goal {
    /** Checks the count. */
    public Samples {
      Check.range("samples", count, 1, RenderSettings.MAX_SAMPLES);
    }
  }

  /**
   * An estimated error, or the end of a time, whichever comes first. A first picture, of a ray
   * through every pixel's corner, is finished in any case.
   *
   * @param levels the RMS error of the image in display levels, 0 for as small as can be
   * @param seconds of rendering, infinite for no limit
   */
  record Error(double levels, double seconds) implements Goal {
    /** Checks that both are not negative, and that one of them can be reached. */
    public Error {
      Check.range("max-error", levels, 0, 255);
      if (!(seconds > 0) || (levels == 0 && seconds == Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException("no render ends without an error or a time to end at");
      }
    }

    /** Without a limit of time. */
    public Error(double levels) {
      this(levels, Double.POSITIVE_INFINITY);
    }
  }
}

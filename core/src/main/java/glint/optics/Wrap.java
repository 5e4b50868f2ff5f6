package glint.optics;

/** What an image shows beyond its edges. */
public enum Wrap {
  /** The image again. */
  REPEAT {
    @Override
    double within(double u) {
      return u - Math.floor(u);
    }
  },

  /** The colour at the edge. */
  CLAMP {
    @Override
    double within(double u) {
      return Math.min(Math.max(u, 0), 1);
    }
  },

  /** The image again, every other time turned over. */
  MIRROR {
    @Override
    double within(double u) {
      return 1 - Math.abs(1 - (u - 2 * Math.floor(u / 2)));
    }
  };

  /** Returns the place, 0 to 1, that a finite coordinate shows. */
  abstract double within(double u);
}

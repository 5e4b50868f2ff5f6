package glint.color;

/** The curve from linear light to eight-bit display codes. */
public enum Transfer {
  /** The exact sRGB curve of IEC 61966-2-1; codes are rounded to nearest. */
  SRGB {
    @Override
    public double encode(double linear) {
      if (linear <= 0.0031308) {
        return 12.92 * linear;
      }
      return 1.055 * StrictMath.pow(linear, 1 / 2.4) - 0.055;
    }

    @Override
    public double decode(double encoded) {
      if (encoded <= 0.04045) {
        return encoded / 12.92;
      }
      return StrictMath.pow((encoded + 0.055) / 1.055, 2.4);
    }

    @Override
    public int code(double linear) {
      return SrgbCodes.of(clamp(linear));
    }
  },

  /** Codes of the linear value itself, {@code floor(255 c)}, as the CS 315 course writes them. */
  LINEAR {
    @Override
    public double encode(double linear) {
      return linear;
    }

    @Override
    public double decode(double encoded) {
      return encoded;
    }

    @Override
    public int code(double linear) {
      return (int) (255 * clamp(linear));
    }
  };

  /** Returns the display value of a linear value, both in [0, 1]. */
  public abstract double encode(double linear);

  /** Returns the linear value of a display value, both in [0, 1]; the inverse of encode. */
  public abstract double decode(double encoded);

  /** Returns the code 0 to 255 of a linear value; values outside [0, 1] are clamped, NaN is 0. */
  public abstract int code(double linear);

  /** Returns the display level of a linear value, 0 to 255, unrounded: the unit of all errors. */
  public double level(double linear) {
    return 255 * encode(clamp(linear));
  }

  /** Returns {@code v} limited to [0, 1]; NaN becomes 0 and is counted elsewhere. */
  static double clamp(double v) {
    return v > 0 ? Math.min(v, 1) : 0;
  }
}

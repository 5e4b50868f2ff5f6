package glint.image;

import glint.color.Transfer;

/**
 * The colour spaces of FLIP, with the constants of its authors' implementation.
 *
 * <p>The opponent space is YCxCz without its factors 116, 500 and 200 and its offset 16: Y, X - Y
 * and Y - Z relative to the white point. FLIP only filters it with kernels of sum 1 and goes back,
 * so they cancel. Colours are read from and written to pixel i of three planes.
 */
final class FlipColor {

  private static final double WHITE_X = 0.950428545;
  private static final double WHITE_Z = 1.088900371;
  private static final double PER_WHITE_X = 1.052156925;
  private static final double PER_WHITE_Z = 0.918357670;

  private static final double LAB_DELTA = 6.0 / 29;

  private FlipColor() {}

  /** Writes the opponent colour of the pixel that an sRGB display shows for these values. */
  static void opponent(double[][] display, double[][] opponent, int i) {
    double r = Transfer.SRGB.decode(display[0][i]);
    double g = Transfer.SRGB.decode(display[1][i]);
    double b = Transfer.SRGB.decode(display[2][i]);
    double y = luminance(r, g, b);
    opponent[0][i] = y;
    opponent[1][i] = relativeX(r, g, b) - y;
    opponent[2][i] = y - relativeZ(r, g, b);
  }

  /**
   * Replaces an opponent colour by the L*a*b* colour with Hunt's adjustment (a* and b* times L* /
   * 100) of what remains of it in the cube of displayable colours.
   */
  static void opponentToHuntLab(double[][] planes, int i) {
    double y = planes[0][i];
    double x = (y + planes[1][i]) * WHITE_X;
    double z = (y - planes[2][i]) * WHITE_Z;
    double r = unit(3.241003275 * x - 1.537398934 * y - 0.498615861 * z);
    double g = unit(-0.969224334 * x + 1.875930071 * y + 0.041554224 * z);
    double b = unit(0.055639423 * x - 0.204011202 * y + 1.057148933 * z);
    toHuntLab(r, g, b, planes, i);
  }

  /** Writes the Hunt-adjusted L*a*b* colour of a linear colour. */
  static void toHuntLab(double r, double g, double b, double[][] lab, int i) {
    double x = labCurve(relativeX(r, g, b));
    double y = labCurve(luminance(r, g, b));
    double z = labCurve(relativeZ(r, g, b));
    double lightness = 116 * y - 16;
    lab[0][i] = lightness;
    lab[1][i] = 0.01 * lightness * 500 * (x - y);
    lab[2][i] = 0.01 * lightness * 200 * (y - z);
  }

  /** Returns the distance of two L*a*b* colours: city block in L*, Euclidean in a* and b*. */
  static double hyAb(double[][] a, int i, double[][] b, int j) {
    double da = a[1][i] - b[1][j];
    double db = a[2][i] - b[2][j];
    return Math.abs(a[0][i] - b[0][j]) + Math.sqrt(da * da + db * db);
  }

  private static double relativeX(double r, double g, double b) {
    return (10135552 * r + 8788810 * g + 4435075 * b) / 24577794 * PER_WHITE_X;
  }

  private static double luminance(double r, double g, double b) {
    return (2613072 * r + 8788810 * g + 887015 * b) / 12288897;
  }

  private static double relativeZ(double r, double g, double b) {
    return (1425312 * r + 8788810 * g + 70074185 * b) / 73733382 * PER_WHITE_Z;
  }

  private static double labCurve(double t) {
    if (t > LAB_DELTA * LAB_DELTA * LAB_DELTA) {
      return StrictMath.cbrt(t);
    }
    return t / (3 * LAB_DELTA * LAB_DELTA) + 4.0 / 29;
  }

  private static double unit(double v) {
    return Math.min(Math.max(v, 0), 1);
  }
}

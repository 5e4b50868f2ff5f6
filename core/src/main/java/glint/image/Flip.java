package glint.image;

/**
 * LDR-FLIP: the error that one sees when two images are shown in turns, after Andersson, Nilsson,
 * Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
 * Images" (2020), at the viewing distance that their implementation takes by default.
 */
final class Flip {

  private static final double COLOR_EXPONENT = 0.7;
  private static final double FEATURE_EXPONENT = 0.5;
  private static final double KNEE_IN = 0.4;
  private static final double KNEE_OUT = 0.95;

  private Flip() {}

  /**
   * Returns the error of every pixel, from 0 (not seen) to 1, row by row.
   *
   * <p>The images are planes of red, green and blue display values in [0, 1], as an sRGB display is
   * given them.
   */
  static double[] map(double[][] test, double[][] reference, int width, int height) {
    FlipView a = new FlipView(test, width, height);
    FlipView b = new FlipView(reference, width, height);
    double greatest = greatestColorError();
    double[] map = new double[width * height];
    for (int i = 0; i < map.length; i++) {
      double color = StrictMath.pow(FlipColor.hyAb(a.lab, i, b.lab, i), COLOR_EXPONENT);
      double edge = Math.abs(a.edges[i] - b.edges[i]);
      double point = Math.abs(a.points[i] - b.points[i]);
      double feature = StrictMath.pow(Math.max(edge, point) / Math.sqrt(2), FEATURE_EXPONENT);
      map[i] = StrictMath.pow(redistribute(color, greatest), 1 - feature);
    }
    return map;
  }

  /** Maps colour errors to [0, 1], most of which goes to the small ones. */
  private static double redistribute(double color, double greatest) {
    double knee = KNEE_IN * greatest;
    if (color < knee) {
      return color * KNEE_OUT / knee;
    }
    return KNEE_OUT + (color - knee) / (greatest - knee) * (1 - KNEE_OUT);
  }

  /** Returns the colour error between green and blue, the farthest pair of display colours. */
  private static double greatestColorError() {
    double[][] pair = new double[3][2];
    FlipColor.toHuntLab(0, 1, 0, pair, 0);
    FlipColor.toHuntLab(0, 0, 1, pair, 1);
    return StrictMath.pow(FlipColor.hyAb(pair, 0, pair, 1), COLOR_EXPONENT);
  }
}

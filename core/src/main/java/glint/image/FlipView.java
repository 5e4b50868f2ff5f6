package glint.image;

/**
 * What FLIP's observer makes of one image: the colours that the eye resolves at this distance, and
 * how much of an edge and of a point there is in every pixel.
 */
final class FlipView {

  /** A display 3840 pixels and 0.7 m wide at a distance of 0.7 m: 67.02. */
  private static final double PIXELS_PER_DEGREE = 3840 * Math.PI / 180;

  // Contrast sensitivity (table 1 of the paper): a · sqrt(π / b) · exp(-π² x² / b), x in degrees
  private static final double SCALE_ACHROMATIC = 0.0047;
  private static final double SCALE_RED_GREEN = 0.0053;
  private static final double SCALE_BLUE_YELLOW_WIDE = 0.04;
  private static final double SCALE_BLUE_YELLOW_NARROW = 0.025;
  private static final double WEIGHT_BLUE_YELLOW_WIDE = 34.1;
  private static final double WEIGHT_BLUE_YELLOW_NARROW = 13.5;

  /** Peak-to-trough distance of the eye's edge detector, in degrees. */
  private static final double EDGE_WIDTH = 0.082;

  final double[][] lab;
  final double[] edges;
  final double[] points;

  private final int width;
  private final int height;

  /** Looks at an image given as planes of display values. */
  FlipView(double[][] display, int width, int height) {
    this.width = width;
    this.height = height;
    double[][] opponent = new double[3][width * height];
    for (int i = 0; i < width * height; i++) {
      FlipColor.opponent(display, opponent, i);
    }
    double deviation = 0.5 * EDGE_WIDTH * PIXELS_PER_DEGREE;
    double[] smooth = Separable.gaussian(radius(deviation), 1 / (2 * deviation * deviation));
    this.edges = features(opponent[0], smooth, firstDerivative(smooth));
    this.points = features(opponent[0], smooth, secondDerivative(smooth, deviation));
    this.lab = resolvedColors(opponent);
  }

  private double[][] resolvedColors(double[][] opponent) {
    double[][] planes = new double[3][];
    planes[0] = blur(opponent[0], SCALE_ACHROMATIC);
    planes[1] = blur(opponent[1], SCALE_RED_GREEN);
    planes[2] = blur(opponent[2], SCALE_BLUE_YELLOW_WIDE);
    double[] narrow = blur(opponent[2], SCALE_BLUE_YELLOW_NARROW);
    double wideShare = wideShare();
    for (int i = 0; i < narrow.length; i++) {
      planes[2][i] = wideShare * planes[2][i] + (1 - wideShare) * narrow[i];
      FlipColor.opponentToHuntLab(planes, i);
    }
    return planes;
  }

  private double[] blur(double[] plane, double scale) {
    double[] kernel = sensitivity(scale);
    return Separable.filter(plane, width, height, kernel, kernel);
  }

  /** Returns a sensitivity kernel; all have the radius of the widest, as in the reference. */
  private static double[] sensitivity(double scale) {
    double deviation = Math.sqrt(SCALE_BLUE_YELLOW_WIDE / (2 * Math.PI * Math.PI));
    double perPixel = Math.PI / PIXELS_PER_DEGREE;
    return Separable.gaussian(radius(deviation * PIXELS_PER_DEGREE), perPixel * perPixel / scale);
  }

  /** Returns the share of the wide Gaussian in the sum of the two of the blue-yellow kernel. */
  private static double wideShare() {
    double wide = blueYellowVolume(WEIGHT_BLUE_YELLOW_WIDE, SCALE_BLUE_YELLOW_WIDE);
    double narrow = blueYellowVolume(WEIGHT_BLUE_YELLOW_NARROW, SCALE_BLUE_YELLOW_NARROW);
    return wide / (wide + narrow);
  }

  /** Returns the sum of one Gaussian of the blue-yellow kernel over the pixels of its square. */
  private static double blueYellowVolume(double weight, double scale) {
    double[] kernel = sensitivity(scale);
    // The middle is exp(0) = 1 before the scaling to the sum 1
    double sum = 1 / kernel[kernel.length / 2];
    return weight * Math.sqrt(Math.PI / scale) * sum * sum;
  }

  /** Returns the length of the vector of the plane's derivatives along x and along y. */
  private double[] features(double[] plane, double[] smooth, double[] derivative) {
    double[] alongX = Separable.filter(plane, width, height, derivative, smooth);
    double[] alongY = Separable.filter(plane, width, height, smooth, derivative);
    for (int i = 0; i < alongX.length; i++) {
      alongX[i] = Math.sqrt(alongX[i] * alongX[i] + alongY[i] * alongY[i]);
    }
    return alongX;
  }

  private static double[] firstDerivative(double[] smooth) {
    double[] kernel = new double[smooth.length];
    for (int i = 0; i < kernel.length; i++) {
      kernel[i] = (kernel.length / 2 - i) * smooth[i];
    }
    return balanced(kernel);
  }

  private static double[] secondDerivative(double[] smooth, double deviation) {
    double[] kernel = new double[smooth.length];
    for (int i = 0; i < kernel.length; i++) {
      double k = (i - kernel.length / 2) / deviation;
      kernel[i] = (k * k - 1) * smooth[i];
    }
    return balanced(kernel);
  }

  /** Scales the positive weights to the sum 1 and the negative ones to the sum -1, in place. */
  private static double[] balanced(double[] kernel) {
    double positive = 0;
    double negative = 0;
    for (double weight : kernel) {
      positive += Math.max(weight, 0);
      negative -= Math.min(weight, 0);
    }
    for (int i = 0; i < kernel.length; i++) {
      kernel[i] /= kernel[i] > 0 ? positive : negative;
    }
    return kernel;
  }

  private static int radius(double deviation) {
    return (int) StrictMath.ceil(3 * deviation);
  }
}

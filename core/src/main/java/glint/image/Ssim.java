package glint.image;

/**
 * The structural similarity of Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from
 * error visibility to structural similarity" (2004), on display values in [0, 1].
 *
 * <p>As published: an 11 × 11 Gaussian window of deviation 1.5, K1 = 0.01, K2 = 0.03, variances
 * without Bessel's correction, the mean over all windows that lie inside the image. The paper
 * treats grey images; of a colour image each channel counts as one and the three are averaged, as
 * scikit-image does, so that a wrong hue is not missed. On a side shorter than 11 pixels the window
 * shrinks to the largest odd number of pixels that fits.
 */
final class Ssim {

  private static final double C1 = 0.01 * 0.01;
  private static final double C2 = 0.03 * 0.03;
  private static final int RADIUS = 5;
  private static final double RATE = 1 / (2 * 1.5 * 1.5);

  private final int width;
  private final int height;
  private final double[] alongX;
  private final double[] alongY;

  private Ssim(int width, int height) {
    this.width = width;
    this.height = height;
    this.alongX = Separable.gaussian(Math.min(RADIUS, (width - 1) / 2), RATE);
    this.alongY = Separable.gaussian(Math.min(RADIUS, (height - 1) / 2), RATE);
  }

  /** Returns the similarity of two images given as planes of display values: 1 if equal. */
  static double of(double[][] a, double[][] b, int width, int height) {
    Ssim window = new Ssim(width, height);
    double sum = 0;
    for (int channel = 0; channel < a.length; channel++) {
      sum += window.ofPlanes(a[channel], b[channel]);
    }
    return sum / a.length;
  }

  private double ofPlanes(double[] a, double[] b) {
    double[] meanA = local(a);
    double[] meanB = local(b);
    double[] meanAa = local(product(a, a));
    double[] meanBb = local(product(b, b));
    double[] meanAb = local(product(a, b));
    int left = alongX.length / 2;
    int top = alongY.length / 2;
    double sum = 0;
    for (int y = top; y < height - top; y++) {
      for (int x = left; x < width - left; x++) {
        int i = y * width + x;
        double ab = meanA[i] * meanB[i];
        double squares = meanA[i] * meanA[i] + meanB[i] * meanB[i];
        double covariance = meanAb[i] - ab;
        double variances = meanAa[i] + meanBb[i] - squares;
        sum += (2 * ab + C1) * (2 * covariance + C2) / ((squares + C1) * (variances + C2));
      }
    }
    return sum / ((double) (width - 2 * left) * (height - 2 * top));
  }

  private double[] local(double[] plane) {
    return Separable.filter(plane, width, height, alongX, alongY);
  }

  private static double[] product(double[] a, double[] b) {
    double[] product = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      product[i] = a[i] * b[i];
    }
    return product;
  }
}

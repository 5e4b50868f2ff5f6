package glint.image;

import glint.color.Transfer;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

/**
 * How far an image is from a reference, over all channels of all pixels.
 *
 * <p>Linear light is compared without clamping. What depends on the display (psnr, ssim, flip,
 * levels) is taken from the display values {@code encode(clamp(x, 0, 1))}, unrounded; a display is
 * taken to show the codes as sRGB whatever the transfer curve was, as every viewer does. Sums run
 * in row order, so the same images give the same bits.
 *
 * <p>A channel that is NaN or infinite in either image counts as white (1) against black (0), and
 * its pixel is counted in {@code invalid}.
 *
 * @param width columns of both images
 * @param height rows of both images
 * @param rmse root of the mean squared difference, linear
 * @param max largest absolute difference, linear
 * @param mae mean absolute difference, linear
 * @param mrse mean of (difference / (reference + 0.01))², linear, as pbrt has it; a negative
 *     reference counts as 0 in the divisor
 * @param psnr peak signal-to-noise ratio of the display values in dB; empty if these are equal
 * @param ssim structural similarity of the display values (Wang et al. 2004), mean of the channels
 * @param flipMean mean of the LDR-FLIP error map (Andersson et al. 2020)
 * @param flipP99 its 99th percentile, interpolated between the two nearest ranks
 * @param levelsRmse root mean square of the differences in eight-bit display levels
 * @param levelsMax largest absolute difference in eight-bit display levels
 * @param invalid pixels with a channel that is NaN or infinite in either image
 * @param worst the ten pixels (all, if there are fewer) with the largest absolute linear difference
 *     of a channel, the largest first, equal ones in row order
 */
public record Comparison(
    int width,
    int height,
    double rmse,
    double max,
    double mae,
    double mrse,
    OptionalDouble psnr,
    double ssim,
    double flipMean,
    double flipP99,
    double levelsRmse,
    double levelsMax,
    int invalid,
    List<PixelError> worst) {

  /** A pixel and its largest absolute linear difference of a channel. */
  public record PixelError(int x, int y, double delta) {}

  /**
   * Compares an image with a reference.
   *
   * @param transfer the curve from linear light to display values
   * @throws IllegalArgumentException if the sizes differ; the message holds both
   */
  public static Comparison of(Image image, Image reference, Transfer transfer) {
    ImagePair pair = new ImagePair(image, reference);
    int width = pair.width();
    int height = pair.height();
    double[][] a = pair.imageDisplay(transfer);
    double[][] b = pair.referenceDisplay(transfer);
    LinearErrors linear = new LinearErrors(pair);
    double displayMse = meanSquare(a, b);
    double[] flip = Flip.map(a, b, width, height);
    return new Comparison(
        width,
        height,
        linear.rmse(),
        linear.max(),
        linear.mae(),
        linear.mrse(),
        displayMse > 0
            ? OptionalDouble.of(-10 * StrictMath.log10(displayMse))
            : OptionalDouble.empty(),
        Ssim.of(a, b, width, height),
        mean(flip),
        percentile99(flip),
        255 * Math.sqrt(displayMse),
        255 * largestDifference(a, b),
        linear.invalid(),
        linear.worst());
  }

  private static double meanSquare(double[][] a, double[][] b) {
    double sum = 0;
    for (int i = 0; i < a[0].length; i++) {
      for (int channel = 0; channel < 3; channel++) {
        double delta = a[channel][i] - b[channel][i];
        sum += delta * delta;
      }
    }
    return sum / (3.0 * a[0].length);
  }

  private static double largestDifference(double[][] a, double[][] b) {
    double largest = 0;
    for (int channel = 0; channel < 3; channel++) {
      for (int i = 0; i < a[channel].length; i++) {
        largest = Math.max(largest, Math.abs(a[channel][i] - b[channel][i]));
      }
    }
    return largest;
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return sum / values.length;
  }

  private static double percentile99(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    double rank = 0.99 * (sorted.length - 1);
    int below = (int) rank;
    int above = Math.min(below + 1, sorted.length - 1);
    return sorted[below] + (rank - below) * (sorted[above] - sorted[below]);
  }
}

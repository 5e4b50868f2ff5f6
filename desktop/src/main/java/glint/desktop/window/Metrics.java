package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Comparison;
import glint.image.Image;
import java.util.Locale;

/** Says in words how far an image is from another. */
final class Metrics {

  private Metrics() {}

  /** Returns one line; it takes a while. */
  static String words(Image image, Image reference, Transfer transfer) {
    Comparison c = Comparison.of(image, reference, transfer);
    if (c.max() == 0) {
      return "equal, bit for bit";
    }
    return String.format(
        Locale.ROOT,
        "RMSE %.3g levels, largest %.3g; PSNR %.1f dB, SSIM %.4f, FLIP %.4f",
        c.levelsRmse(),
        c.levelsMax(),
        c.psnr().orElse(Double.POSITIVE_INFINITY),
        c.ssim(),
        c.flipMean());
  }
}

package glint.image;

import glint.color.Transfer;
import java.util.function.IntToDoubleFunction;

/**
 * An image and its reference, of the same size, with the values by which they are compared: where
 * either is NaN or infinite, the image counts as white and the reference as black.
 */
final class ImagePair {

  private final Image image;
  private final Image reference;

  /** Throws an IllegalArgumentException if the sizes differ. */
  ImagePair(Image image, Image reference) {
    if (image.width() != reference.width() || image.height() != reference.height()) {
      throw new IllegalArgumentException(
          "the images differ in size: " + size(image) + " and " + size(reference));
    }
    this.image = image;
    this.reference = reference;
  }

  int width() {
    return image.width();
  }

  int height() {
    return image.height();
  }

  /** Returns whether value i (of {@link Image#rgb()}) is finite in both images. */
  boolean isValid(int i) {
    return Double.isFinite(image.rgb()[i]) && Double.isFinite(reference.rgb()[i]);
  }

  /** Returns value i of the image. */
  double image(int i) {
    return isValid(i) ? image.rgb()[i] : 1;
  }

  /** Returns value i of the reference. */
  double reference(int i) {
    return isValid(i) ? reference.rgb()[i] : 0;
  }

  /** Returns the display values of the image as three planes: red, green, blue. */
  double[][] imageDisplay(Transfer transfer) {
    return display(this::image, transfer);
  }

  /** Returns the display values of the reference as three planes: red, green, blue. */
  double[][] referenceDisplay(Transfer transfer) {
    return display(this::reference, transfer);
  }

  private double[][] display(IntToDoubleFunction linear, Transfer transfer) {
    double[][] planes = new double[3][width() * height()];
    for (int i = 0; i < 3 * planes[0].length; i++) {
      planes[i % 3][i / 3] = transfer.encode(clamp(linear.applyAsDouble(i)));
    }
    return planes;
  }

  private static double clamp(double v) {
    return Math.min(Math.max(v, 0), 1);
  }

  private static String size(Image image) {
    return image.width() + "x" + image.height();
  }
}

package glint.report;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import java.util.List;

/**
 * How far values are from what they should be, over all channels.
 *
 * @param levels root mean square in display levels, 255·encode(clamp(x, 0, 1)), unrounded
 * @param maxLevels the largest difference in display levels
 * @param linear root mean square in linear light
 * @param maxLinear the largest difference in linear light
 */
public record Errors(double levels, double maxLevels, double linear, double maxLinear) {

  /**
   * Compares two images of one size, in row order.
   *
   * @throws IllegalArgumentException if the sizes differ
   */
  public static Errors between(Image image, Image truth, Transfer transfer) {
    requireSameSize(image, truth);
    Sum sum = new Sum(transfer);
    for (int i = 0; i < image.rgb().length; i++) {
      sum.add(image.rgb()[i], truth.rgb()[i]);
    }
    return sum.errors();
  }

  /**
   * Returns the error of every pixel, in row order: the root mean square over its channels, in
   * display levels.
   *
   * @throws IllegalArgumentException if the sizes differ
   */
  public static double[] ofPixels(Image image, Image truth, Transfer transfer) {
    requireSameSize(image, truth);
    double[] errors = new double[image.width() * image.height()];
    for (int i = 0; i < errors.length; i++) {
      Sum sum = new Sum(transfer);
      for (int channel = 0; channel < 3; channel++) {
        sum.add(image.rgb()[3 * i + channel], truth.rgb()[3 * i + channel]);
      }
      errors[i] = sum.errors().levels();
    }
    return errors;
  }

  /** Returns the errors of several runs together: root mean squares, and the largest of all. */
  public static Errors together(List<Errors> runs) {
    double levels = 0;
    double maxLevels = 0;
    double linear = 0;
    double maxLinear = 0;
    for (Errors run : runs) {
      levels += run.levels * run.levels;
      maxLevels = Math.max(maxLevels, run.maxLevels);
      linear += run.linear * run.linear;
      maxLinear = Math.max(maxLinear, run.maxLinear);
    }
    return new Errors(
        Math.sqrt(levels / runs.size()), maxLevels, Math.sqrt(linear / runs.size()), maxLinear);
  }

  private static void requireSameSize(Image image, Image truth) {
    if (image.width() != truth.width() || image.height() != truth.height()) {
      throw new IllegalArgumentException("the images differ in size");
    }
  }

  /** Gathers the differences of single values. */
  static final class Sum {

    private final Transfer transfer;
    private long count;
    private double levels;
    private double maxLevels;
    private double linear;
    private double maxLinear;

    Sum(Transfer transfer) {
      this.transfer = transfer;
    }

    void add(double value, double truth) {
      double delta = Math.abs(value - truth);
      double shown = Math.abs(transfer.level(value) - transfer.level(truth));
      count++;
      levels += shown * shown;
      maxLevels = Math.max(maxLevels, shown);
      linear += delta * delta;
      maxLinear = Math.max(maxLinear, delta);
    }

    void add(Rgb value, Rgb truth) {
      add(value.r(), truth.r());
      add(value.g(), truth.g());
      add(value.b(), truth.b());
    }

    Errors errors() {
      return new Errors(Math.sqrt(levels / count), maxLevels, Math.sqrt(linear / count), maxLinear);
    }
  }
}

package glint.scene;

import glint.color.Rgb;
import glint.math.BadValueException;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What a scene says that its own picture shows, in linear light; immutable. Nothing in it changes
 * the picture.
 *
 * @param pixel the pixel that it speaks of; if absent, the mean over all pixels
 * @param value what is expected there
 * @param tolerance by how much a channel may differ
 * @param relative by which share of its expected value a channel may differ instead, if that is
 *     more
 * @param samples the samples of every pixel to render with
 * @param maxDepth the most successive bounces to render with, if it is stated
 */
public record Expectation(
    Optional<Pixel> pixel,
    Rgb value,
    double tolerance,
    double relative,
    int samples,
    OptionalInt maxDepth) {

  /** A column from the left and a row from the top, both from 0. */
  public record Pixel(int x, int y) {}

  /** Checks that the value is light, and that both tolerances are finite and not negative. */
  public Expectation {
    Objects.requireNonNull(pixel, "pixel");
    value.requireLight(pixel.isPresent() ? "value" : "mean");
    requireTolerance("tolerance", tolerance);
    requireTolerance("relative", relative);
  }

  /** Returns by how much a channel may differ from what is expected of it. */
  public double allowed(double expected) {
    return Math.max(tolerance, relative * expected);
  }

  private static void requireTolerance(String field, double v) {
    if (!(v >= 0 && v < Double.POSITIVE_INFINITY)) {
      throw new BadValueException(field, "must not be negative or infinite, but is " + v);
    }
  }
}

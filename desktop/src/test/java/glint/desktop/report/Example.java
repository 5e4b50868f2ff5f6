package glint.desktop.report;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import glint.report.Answers;
import glint.report.Curve;
import glint.report.Errors;
import glint.report.Measurement;
import glint.report.Rays;
import glint.report.Reference;
import glint.report.Spread;
import glint.report.Truth;
import glint.scene.Expectation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** A report whose figures are known. */
final class Example {

  private static final Expectation MEAN =
      new Expectation(Optional.empty(), Rgb.grey(0.5), 0, 0, 16, OptionalInt.empty());

  private Example() {}

  /** Two scenes: one follows 10/n levels at n ms and 1000 n rays, one is exact at once. */
  static Report report() {
    Report.Environment environment =
        new Report.Environment("9.9", "abc1234", "Some JVM", "Some machine <1 & only>", 2);
    Image image = new Image(1, 1);
    Truth reference = new Reference(image, "2 × 32 samples", 0.125, Transfer.LINEAR);
    Truth mean = new Answers(List.of(MEAN), Transfer.SRGB);
    return new Report(
        "glint report a",
        environment,
        List.of(
            new Report.Entry(
                "a|b.yaml", "law", "A <scene> & more", 8, 6, curve(reference, 10, true)),
            new Report.Entry("b.yaml", "exact", "exact", 4, 4, curve(mean, 0, false))));
  }

  private static Curve curve(Truth truth, double error, boolean complete) {
    List<Measurement> points = new ArrayList<>();
    for (int n = 1; n <= 16; n *= 2) {
      Errors run = new Errors(error / n, 2 * error / n, error / n / 255, error / n / 100);
      Spread seconds = new Spread(n * 0.5e-3, n * 1e-3, n * 2e-3);
      Rays rays = new Rays(500.0 * n, 300.0 * n, 0, 200.0 * n);
      points.add(
          new Measurement(
              n, List.of(run, run), seconds, rays, truth.uncertainty() * 10 <= error / n));
    }
    return new Curve(truth, points, 0.25, complete);
  }
}

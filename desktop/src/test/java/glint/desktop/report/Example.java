package glint.desktop.report;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.image.Image;
import glint.report.Answers;
import glint.report.Curve;
import glint.report.DepthStudy;
import glint.report.Errors;
import glint.report.Honesty;
import glint.report.Measurement;
import glint.report.Rays;
import glint.report.Reference;
import glint.report.Spread;
import glint.report.TargetRuns;
import glint.report.TargetStudy;
import glint.report.ThinLines;
import glint.report.Truth;
import glint.scene.Expectation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
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
            entry("a|b.yaml", "law", "A <scene> & more", curve(reference, 10, true), 1),
            entry("b.yaml", "exact", "exact", curve(mean, 0, false), 0)),
        List.of(new ThinLines.Count(0.05, 2000, 7)));
  }

  /** Renders to an error that are as far off as asked, with two samples' rays and seconds. */
  static Report.Entry entry(String file, String name, String title, Curve curve, int off) {
    List<TargetRuns> runs = new ArrayList<>();
    for (double target : new double[] {4, 1}) {
      double error = off * target / 2;
      Honesty.Claim claim = new Honesty.Claim(target, 0.8 * target, error);
      Errors errors = new Errors(error, 2 * error, error / 255, error / 100);
      Rays rays = new Rays(2000, 0, 0, 0);
      runs.add(
          new TargetRuns(
              target,
              List.of(claim, claim),
              List.of(errors, errors),
              Spread.of(2e-3),
              rays,
              1.5,
              0.25));
    }
    TargetStudy.Worst worst = new TargetStudy.Worst(2, 1, 3.5, 1.5, 9);
    TargetStudy targets =
        new TargetStudy(
            runs,
            new double[] {1, 2, 0},
            new double[] {off, 4.0 * off, 0},
            off == 0 ? List.of() : List.of(worst));
    DepthStudy depths =
        new DepthStudy(
            List.of(
                new DepthStudy.Point(0, 8 * off, 9, 1e-3, 1000),
                new DepthStudy.Point(3, 0, 0.25, 4e-3, 4000)));
    List<String> replays = off == 0 ? List.of() : List.of("glint replay a");
    return new Report.Entry(
        file,
        name,
        title,
        off == 0 ? 4 : 8,
        off == 0 ? 4 : 6,
        curve,
        targets,
        depths,
        replays,
        off == 0 ? OptionalDouble.of(0.5) : OptionalDouble.empty());
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

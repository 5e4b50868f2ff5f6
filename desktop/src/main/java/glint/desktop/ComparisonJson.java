package glint.desktop;

import glint.image.Comparison;
import java.util.List;

/** A comparison in the form of its JSON; the names are a contract with scripts. */
record ComparisonJson(
    double rmse,
    double max,
    double mae,
    double mrse,
    Double psnr,
    double ssim,
    Flip flip,
    Levels levels,
    int width,
    int height,
    int invalid,
    List<Number[]> worst) {

  /** Of the FLIP error map. */
  record Flip(double mean, double p99) {}

  /** In eight-bit display levels. */
  record Levels(double rmse, double max) {}

  /** Rearranges a comparison. */
  static ComparisonJson of(Comparison c) {
    return new ComparisonJson(
        c.rmse(),
        c.max(),
        c.mae(),
        c.mrse(),
        c.psnr().isPresent() ? c.psnr().getAsDouble() : null,
        c.ssim(),
        new Flip(c.flipMean(), c.flipP99()),
        new Levels(c.levelsRmse(), c.levelsMax()),
        c.width(),
        c.height(),
        c.invalid(),
        c.worst().stream().map(w -> new Number[] {w.x(), w.y(), w.delta()}).toList());
  }
}

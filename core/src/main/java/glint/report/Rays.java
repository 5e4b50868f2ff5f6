package glint.report;

import glint.trace.RayCounts;
import java.util.List;

/** Rays of an image by kind, on average over several runs. */
public record Rays(double camera, double reflection, double refraction, double shadow) {

  /** Returns the mean of some counts. */
  static Rays mean(List<RayCounts> runs) {
    RayCounts sum = new RayCounts();
    runs.forEach(sum::add);
    double n = runs.size();
    return new Rays(sum.camera / n, sum.reflection / n, sum.refraction / n, sum.shadow / n);
  }

  /** Returns the number of rays of all kinds. */
  public double total() {
    return camera + reflection + refraction + shadow;
  }
}

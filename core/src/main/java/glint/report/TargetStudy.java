package glint.report;

import glint.image.Image;
import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * What images that are rendered to an error cost, claim, and are really off by.
 *
 * @param runs by falling target
 * @param claimed what every pixel of one image at a target of one level claims, in display levels
 * @param actual how far each is really off
 * @param worst the pixels of that image that are off most, the worst first
 */
public record TargetStudy(
    List<TargetRuns> runs, double[] claimed, double[] actual, List<Worst> worst) {

  /** Images of each target. */
  public static final int RUNS = 8;

  /** The errors that are asked for, in display levels. */
  private static final double[] TARGETS = {4, 2, 1, 0.5};

  /** The goal whose pixels are looked at. */
  public static final Goal LOOKED_AT = new Goal.Error(1);

  private static final int WORST = 10;

  /**
   * A pixel that is off.
   *
   * @param x its column
   * @param y its row
   * @param actual by how much, in display levels
   * @param claimed by how much it claims
   * @param samples the camera rays that it took
   */
  public record Worst(int x, int y, double actual, double claimed, int samples) {}

  /** Renders and compares with an image. */
  public static TargetStudy of(Study.Render render, RenderSettings settings, Reference truth) {
    List<TargetRuns> all = new ArrayList<>();
    for (double target : TARGETS) {
      all.add(measure(render, settings, truth, target));
    }
    Set<Aov> aovs = Set.of(Aov.ERROR, Aov.SAMPLES);
    RenderResult result = render.render(settings.aiming(LOOKED_AT, settings.seed(), aovs));
    double[] actual = Errors.ofPixels(result.image(), truth.image(), truth.transfer());
    double[] claimed = reds(result.aovs().get(Aov.ERROR));
    double[] samples = reds(result.aovs().get(Aov.SAMPLES));
    return new TargetStudy(
        List.copyOf(all), claimed, actual, worst(settings.width(), actual, claimed, samples));
  }

  private static TargetRuns measure(
      Study.Render render, RenderSettings settings, Reference truth, double target) {
    Goal goal = new Goal.Error(target);
    List<Honesty.Claim> claims = new ArrayList<>();
    List<Errors> errors = new ArrayList<>();
    List<RayCounts> rays = new ArrayList<>();
    double[] seconds = new double[RUNS];
    double samples = 0;
    double truncation = 0;
    for (int run = 0; run < RUNS; run++) {
      RenderResult result = render.render(settings.aiming(goal, settings.seed() + run, Set.of()));
      Errors error = truth.errors(result.image());
      double cut = result.statistics().truncation();
      double claim = result.statistics().samplingError() + cut;
      claims.add(new Honesty.Claim(target, claim, error.levels()));
      errors.add(error);
      rays.add(result.statistics().rays());
      seconds[run] = result.statistics().renderSeconds();
      samples += result.statistics().meanSamples() / RUNS;
      truncation = Math.max(truncation, cut);
    }
    return new TargetRuns(
        target,
        List.copyOf(claims),
        List.copyOf(errors),
        Spread.of(seconds),
        Rays.mean(rays),
        samples,
        truncation);
  }

  private static double[] reds(Image image) {
    double[] reds = new double[image.width() * image.height()];
    Arrays.setAll(reds, i -> image.rgb()[3 * i]);
    return reds;
  }

  private static List<Worst> worst(int width, double[] actual, double[] claimed, double[] samples) {
    List<Worst> worst = new ArrayList<>();
    int[] order = Ranks.order(actual);
    for (int i = order.length - 1; i >= Math.max(0, order.length - WORST); i--) {
      int pixel = order[i];
      if (actual[pixel] > Curve.NONE) {
        int count = (int) samples[pixel];
        worst.add(new Worst(pixel % width, pixel / width, actual[pixel], claimed[pixel], count));
      }
    }
    return List.copyOf(worst);
  }
}

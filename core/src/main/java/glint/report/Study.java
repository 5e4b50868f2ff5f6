package glint.report;

import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.trace.RayCounts;
import java.util.ArrayList;
import java.util.List;

/** Measures a scene with 1, 2, 4, 8, … samples of every pixel. */
public final class Study {

  /** Images of each number of samples: enough for a smooth curve and a steady median. */
  public static final int RUNS = 8;

  /** Rendering before anything is timed, in seconds: Java compiles what runs often. */
  private static final double WARM_UP = 1;

  private static final double WARM_UP_SHARE = 1 / 16.0;

  /** How much better than the error a truth must be known. */
  private static final double TRUST = 10;

  /** Renders a scene. */
  public interface Render {
    /** Returns the image and its statistics; may throw what {@link glint.render.Renderer} does. */
    RenderResult render(RenderSettings settings);
  }

  private final Render render;
  private final RenderSettings settings;
  private final int most;
  private final double limit;
  private double used;
  private double truncation;
  private double secondsPerSample;

  /**
   * Sets up a study.
   *
   * @param settings their samples are set aside, and their seed is the first of those used
   * @param most the largest number of samples
   * @param limit seconds of rendering after which the samples are not doubled again
   */
  public Study(Render render, RenderSettings settings, int most, double limit) {
    this.render = render;
    this.settings = settings;
    this.most = most;
    this.limit = limit;
  }

  /** Measures everything, against an image that no sample of it is shared with. */
  public Curve run(Truth truth) {
    warmUp();
    List<Measurement> points = new ArrayList<>();
    int samples = 1;
    while (samples <= most && (samples == 1 || used + RUNS * samples * secondsPerSample <= limit)) {
      points.add(measure(samples, truth));
      samples *= 2;
    }
    return new Curve(truth, List.copyOf(points), truncation, samples > most);
  }

  /** Renders until Java has compiled what runs often, and learns what a sample takes. */
  private void warmUp() {
    double spent = 0;
    for (int samples = 1; spent < Math.min(WARM_UP, WARM_UP_SHARE * limit); ) {
      double seconds = render(samples, settings.seed()).statistics().renderSeconds();
      secondsPerSample = seconds / samples;
      spent += seconds;
      samples = Math.min(2 * samples, most);
    }
  }

  private Measurement measure(int samples, Truth truth) {
    List<Errors> errors = new ArrayList<>();
    List<RayCounts> rays = new ArrayList<>();
    double[] seconds = new double[RUNS];
    for (int run = 0; run < RUNS; run++) {
      RenderResult result = render(samples, settings.seed() + run);
      errors.add(truth.errors(result.image()));
      rays.add(result.statistics().rays());
      seconds[run] = result.statistics().renderSeconds();
      truncation = Math.max(truncation, result.statistics().truncation());
    }
    Spread spread = Spread.of(seconds);
    secondsPerSample = spread.median() / samples;
    boolean trusted = TRUST * truth.uncertainty() <= Errors.together(errors).levels();
    return new Measurement(samples, List.copyOf(errors), spread, Rays.mean(rays), trusted);
  }

  private RenderResult render(int samples, long seed) {
    RenderResult result = render.render(settings.sampled(samples, seed));
    used += result.statistics().renderSeconds();
    return result;
  }
}

package glint.verify;

import glint.color.Rgb;
import glint.image.Image;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Expectation;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Whether a scene's picture shows what the scene says; immutable.
 *
 * @param expectation what was expected
 * @param actual what was found there, in linear light
 * @param invalid how many samples of the picture were not finite numbers
 */
public record Verdict(Expectation expectation, Rgb actual, long invalid) {

  /**
   * What is cut off of a ray is at most this share of what may be wrong: rays that split are cut
   * off in many places.
   */
  private static final double CUT = 0x1p-8;

  /** What is cut off where nothing may be wrong at all. */
  private static final double LEAST_CUT = 0x1p-60;

  /** What a picture depends on besides its scene. */
  private record Run(int samples, OptionalInt maxDepth, double negligible) {

    static Run of(Expectation e) {
      double least =
          Arrays.stream(channels(e.value()))
              .map(expected -> CUT * e.allowed(expected))
              .filter(cut -> cut > LEAST_CUT)
              .min()
              .orElse(LEAST_CUT);
      return new Run(e.samples(), e.maxDepth(), least);
    }
  }

  /** Renders a scene, once for each way that its expectations ask for, and checks them in order. */
  public static List<Verdict> of(Scene scene, int threads) {
    Prepared prepared = Prepared.of(scene);
    Map<Run, RenderResult> results = new HashMap<>();
    List<Verdict> verdicts = new ArrayList<>();
    for (Expectation e : scene.expectations()) {
      Run run = Run.of(e);
      RenderResult result = results.computeIfAbsent(run, any -> render(prepared, run, threads));
      Image image = result.image();
      Rgb actual = e.pixel().map(p -> pixel(image, p.x(), p.y())).orElseGet(() -> mean(image));
      verdicts.add(new Verdict(e, actual, result.statistics().invalid()));
    }
    return verdicts;
  }

  private static RenderResult render(Prepared scene, Run run, int threads) {
    RenderSettings settings =
        new RenderSettings(
            scene.scene().width(),
            scene.scene().height(),
            run.samples,
            0,
            run.maxDepth,
            threads,
            RenderSettings.DEFAULT_TILE,
            Set.of());
    RenderSettings fine = settings.following(Math.min(run.negligible, settings.negligible()));
    return new Renderer(scene, fine).render(Progress.NONE);
  }

  private static Rgb pixel(Image image, int x, int y) {
    double[] rgb = image.rgb();
    int i = 3 * (y * image.width() + x);
    return new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]);
  }

  /** Sums up row by row, so that rounding grows with the image's sides and not with its area. */
  private static Rgb mean(Image image) {
    Rgb sum = Rgb.BLACK;
    for (int y = 0; y < image.height(); y++) {
      Rgb row = Rgb.BLACK;
      for (int x = 0; x < image.width(); x++) {
        row = row.plus(pixel(image, x, y));
      }
      sum = sum.plus(row);
    }
    return sum.times(1.0 / ((long) image.width() * image.height()));
  }

  /** Returns whether every channel is as near as it must be, and every sample is a number. */
  public boolean passed() {
    return outcome("", "").passed();
  }

  /**
   * Returns this as a row of {@code glint verify}, with the channel that is worst for what it may
   * be.
   */
  public Outcome outcome(String id, String what) {
    double[] expected = channels(expectation.value());
    double[] found = channels(actual);
    int worst = 0;
    double share = -1;
    for (int i = 0; i < 3; i++) {
      double error = Math.abs(found[i] - expected[i]);
      // 0 of nothing allowed is no share at all, and anything else more than all.
      double ratio = error == 0 ? 0 : error / expectation.allowed(expected[i]);
      if (ratio > share) {
        worst = i;
        share = ratio;
      }
    }
    double error = Math.abs(found[worst] - expected[worst]);
    double bound = expectation.allowed(expected[worst]);
    boolean wrong = invalid > 0 || error > bound;
    return new Outcome(id, what, 1, wrong ? 1 : 0, error, bound, "radiance");
  }

  private static double[] channels(Rgb color) {
    return new double[] {color.r(), color.g(), color.b()};
  }
}

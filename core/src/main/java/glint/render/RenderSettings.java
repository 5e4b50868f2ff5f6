package glint.render;

import glint.math.BadValueException;
import glint.math.Check;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Set;

/**
 * How to render, apart from what; immutable.
 *
 * @param width columns of the image
 * @param height rows of the image
 * @param goal when the image is good enough
 * @param seed chooses another randomisation of the sample sequence
 * @param maxDepth the most successive bounces; if absent, what the scene states, or else {@link
 *     #DEFAULT_DEPTH}
 * @param negligible the radiance below which a bounce is not followed
 * @param threads workers, at least 1
 * @param tileSize edge of a tile in pixels, at least 1
 * @param aovs extra pictures
 */
public record RenderSettings(
    int width,
    int height,
    Goal goal,
    long seed,
    OptionalInt maxDepth,
    double negligible,
    int threads,
    int tileSize,
    Set<Aov> aovs) {

  /** What is not followed by default: a twentieth of a display level at white. */
  private static final double NEGLIGIBLE = 0.05 / 255;

  /** The same where the user states the depth: far below what any image shows. */
  private static final double EXACT = 0x1p-40;

  /** Bounces where neither the user nor the scene sets a limit and no light is lost by them. */
  public static final int DEFAULT_DEPTH = 64;

  /** Samples of a pixel where a number is needed and the user does not say. */
  public static final int DEFAULT_SAMPLES = 16;

  /** The most samples of a pixel. */
  public static final int MAX_SAMPLES = 1 << 24;

  /** The error that is accepted where the user does not say, in display levels. */
  public static final Goal DEFAULT_GOAL = new Goal.Error(1);

  /** The largest limit of bounces. */
  public static final int MAX_DEPTH = 1 << 20;

  /** The most workers. */
  public static final int MAX_THREADS = 1 << 12;

  /** The largest edge of a tile. */
  public static final int MAX_TILE = 1 << 20;

  /** Edge of a tile where the user does not say: small enough to share out, large enough to pay. */
  public static final int DEFAULT_TILE = 32;

  /** Checks the ranges. */
  public RenderSettings {
    Scene.checkSize(width, height);
    Check.range("depth", maxDepth.orElse(0), 0, MAX_DEPTH);
    Check.range("negligible", negligible, 0, Double.MAX_VALUE);
    Check.range("threads", threads, 1, MAX_THREADS);
    Check.range("tile", tileSize, 1, MAX_TILE);
    aovs = Set.copyOf(aovs);
  }

  /** Leaves out what no image shows; next to nothing where the user states the depth. */
  public RenderSettings(
      int width,
      int height,
      Goal goal,
      long seed,
      OptionalInt maxDepth,
      int threads,
      int tileSize,
      Set<Aov> aovs) {
    this(
        width,
        height,
        goal,
        seed,
        maxDepth,
        maxDepth.isPresent() ? EXACT : NEGLIGIBLE,
        threads,
        tileSize,
        aovs);
  }

  /** Returns these settings, but following every bounce that can bring more than a radiance. */
  public RenderSettings following(double least) {
    return new RenderSettings(width, height, goal, seed, maxDepth, least, threads, tileSize, aovs);
  }

  /** Returns the settings of a plain render of a scene on all cores. */
  public static RenderSettings of(Scene scene) {
    return new RenderSettings(
        scene.width(),
        scene.height(),
        DEFAULT_GOAL,
        0,
        OptionalInt.empty(),
        Runtime.getRuntime().availableProcessors(),
        DEFAULT_TILE,
        Set.of());
  }

  /** Takes exactly so many samples of every pixel. */
  public RenderSettings(
      int width,
      int height,
      int samples,
      long seed,
      OptionalInt maxDepth,
      int threads,
      int tileSize,
      Set<Aov> aovs) {
    this(width, height, new Goal.Samples(samples), seed, maxDepth, threads, tileSize, aovs);
  }

  /**
   * Returns the number of samples of every pixel.
   *
   * @throws IllegalStateException if the goal is none
   */
  public int samples() {
    if (goal instanceof Goal.Samples exactly) {
      return exactly.count();
    }
    throw new IllegalStateException("a render to an error has no fixed number of samples");
  }

  /**
   * Checks that a pixel is one of the image.
   *
   * @throws BadValueException if it is outside
   */
  void requirePixel(int column, int row) {
    if (column < 0 || column >= width || row < 0 || row >= height) {
      String image = width + "x" + height;
      throw new BadValueException(
          "pixel", column + "," + row + " is outside of the image, which has " + image + " pixels");
    }
  }

  /** Returns the same with another goal, seed and extra pictures. */
  public RenderSettings aiming(Goal newGoal, long newSeed, Set<Aov> newAovs) {
    return new RenderSettings(
        width, height, newGoal, newSeed, maxDepth, threads, tileSize, newAovs);
  }

  /** Returns the same with a limit of bounces. */
  public RenderSettings atDepth(int depth) {
    return new RenderSettings(
        width, height, goal, seed, OptionalInt.of(depth), threads, tileSize, aovs);
  }

  /** Returns the same with other samples. */
  public RenderSettings sampled(int newSamples, long newSeed) {
    return new RenderSettings(
        width, height, newSamples, newSeed, maxDepth, threads, tileSize, aovs);
  }
}

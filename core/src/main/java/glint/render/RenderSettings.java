package glint.render;

import glint.math.Check;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Set;

/**
 * How to render, apart from what; immutable.
 *
 * @param width columns of the image
 * @param height rows of the image
 * @param samples samples of every pixel, at least 1
 * @param seed chooses another randomisation of the sample sequence
 * @param maxDepth the most successive bounces; if absent, what the scene states, or else {@link
 *     #DEFAULT_DEPTH}
 * @param threads workers, at least 1
 * @param tileSize edge of a tile in pixels, at least 1
 * @param aovs extra pictures
 */
public record RenderSettings(
    int width,
    int height,
    int samples,
    long seed,
    OptionalInt maxDepth,
    int threads,
    int tileSize,
    Set<Aov> aovs) {

  /** Bounces where neither the user nor the scene sets a limit and no light is lost by them. */
  public static final int DEFAULT_DEPTH = 64;

  /** Samples of a pixel where the user does not say. */
  public static final int DEFAULT_SAMPLES = 16;

  /** Edge of a tile where the user does not say: small enough to share out, large enough to pay. */
  public static final int DEFAULT_TILE = 32;

  /** Checks the ranges. */
  public RenderSettings {
    Scene.checkSize(width, height);
    Check.range("samples", samples, 1, 1 << 24);
    Check.range("depth", maxDepth.orElse(0), 0, 1 << 20);
    Check.range("threads", threads, 1, 1 << 12);
    Check.range("tile", tileSize, 1, 1 << 20);
    aovs = Set.copyOf(aovs);
  }

  /** Returns the settings of a plain render of a scene on all cores. */
  public static RenderSettings of(Scene scene) {
    return new RenderSettings(
        scene.width(),
        scene.height(),
        DEFAULT_SAMPLES,
        0,
        OptionalInt.empty(),
        Runtime.getRuntime().availableProcessors(),
        DEFAULT_TILE,
        Set.of());
  }
}

package glint.android;

import glint.scene.Footprint;
import glint.scene.Scene;

/**
 * How much of Java's memory is free, and what scenes and pictures need of it.
 *
 * @param bytes that are free
 */
record Heap(long bytes) {

  /** What a render holds of every pixel: linear colour, corners, estimates, sums of samples. */
  private static final long PIXEL = 144;

  /** While a scene is prepared, it takes so many times as much as afterwards. */
  private static final long BUILDING = 3;

  /** A smaller picture than this is of no use. */
  static final int LEAST_SIDE = 64;

  /** Returns what is free now. */
  static Heap now() {
    Runtime java = Runtime.getRuntime();
    return new Heap(java.maxMemory() - (java.totalMemory() - java.freeMemory()));
  }

  /** Returns how often a picture must be halved, across and down, to fit beside its scene. */
  int halvings(Scene scene, int width, int height) {
    int halvings = 0;
    while (needed(scene, width >> halvings, height >> halvings) > bytes
        && Math.min(width, height) >> (halvings + 1) >= LEAST_SIDE) {
      halvings++;
    }
    return halvings;
  }

  /** Returns whether a scene and a picture of it fit. */
  boolean holds(Scene scene, int width, int height) {
    return needed(scene, width, height) <= bytes;
  }

  /**
   * Returns what a scene's geometry, while it is prepared, and a picture of it need at the most.
   */
  static long needed(Scene scene, int width, int height) {
    return BUILDING * Footprint.of(scene) + PIXEL * width * height;
  }

  /** Returns mebibytes, rounded up. */
  static long mebibytes(long bytes) {
    return (bytes + (1 << 20) - 1) >> 20;
  }
}

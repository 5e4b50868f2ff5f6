package glint.android;

import glint.geometry.Mesh;
import glint.scene.Placement;
import glint.scene.Scene;

/**
 * How much of Java's memory is free, and what scenes and pictures need of it.
 *
 * @param bytes that are free
 */
record Heap(long bytes) {

  /** What a render holds of every pixel: linear colour, corners, estimates, sums of samples. */
  private static final long PIXEL = 144;

  /** What a triangle takes among the primitives and in the tree over them, while it is built. */
  private static final long TRIANGLE = 320;

  /** What a surface takes that is not made of triangles. */
  private static final long SURFACE = 1000;

  /** A smaller picture than this is of no use. */
  private static final int LEAST_SIDE = 64;

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

  /** Returns what a scene's geometry and a picture of it need at the most. */
  static long needed(Scene scene, int width, int height) {
    return geometry(scene) + PIXEL * width * height;
  }

  /** Returns what the geometry of a scene needs at the most, while it is prepared. */
  static long geometry(Scene scene) {
    long sum = 0;
    for (Placement each : scene.placements()) {
      sum += each.surface() instanceof Mesh mesh ? TRIANGLE * mesh.triangles() : SURFACE;
    }
    return sum;
  }

  /** Returns mebibytes, rounded up. */
  static long mebibytes(long bytes) {
    return (bytes + (1 << 20) - 1) >> 20;
  }
}

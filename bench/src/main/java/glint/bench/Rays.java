package glint.bench;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Projection;
import glint.scene.View;
import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Rays of one kind, of unit direction.
 *
 * @param kind what they are called
 * @param any whether any hit will do, rather than the closest
 * @param data for each ray: origin, direction, and how far it reaches
 */
public record Rays(String kind, boolean any, double[] data) {

  /** How many numbers a ray takes. */
  public static final int SIZE = 7;

  private static final int WIDTH = 800;
  private static final int HEIGHT = 600;
  private static final double[] LIGHT = {3, 5, 2};

  /** That of the scene with the displaced sphere. */
  private static final Camera CAMERA =
      new Camera(
          new Vector3d(1.2, 1.6, 3.6),
          new Vector3d(0, 0.95, 0),
          new Vector3d(0, 1, 0),
          Projection.vertical(32),
          0,
          Double.POSITIVE_INFINITY);

  /** Returns how many they are. */
  public int count() {
    return data.length / SIZE;
  }

  /**
   * Makes four kinds: through every pixel of a camera; from where these hit, in random directions
   * as a diffuse surface sends them, and to a light; and between random points of the box [-1, 1] ×
   * [0, 2] × [-1, 1].
   */
  static List<Rays> of(Intersector intersector) {
    int n = WIDTH * HEIGHT;
    double[] primary = new double[SIZE * n];
    double[] diffuse = new double[SIZE * n];
    double[] shadow = new double[SIZE * n];
    View view = new View(CAMERA, WIDTH, HEIGHT);
    SplittableRandom random = new SplittableRandom(1);
    Ray ray = new Ray();
    Hit hit = new Hit();
    int hits = 0;
    for (int i = 0; i < n; i++) {
      int row = i / WIDTH;
      view.ray(i - row * WIDTH + 0.5, row + 0.5, ray);
      put(primary, i, ray, Double.POSITIVE_INFINITY);
      intersector.closest(ray, Double.POSITIVE_INFINITY, hit);
      if (hit.found()) {
        intersector.resolve(ray, hit);
        hit.face(ray);
        scatter(hit, random, ray);
        put(diffuse, hits, ray, Double.POSITIVE_INFINITY);
        put(shadow, hits, ray, toLight(hit, ray));
        hits++;
      }
    }
    double[] between = new double[SIZE * n];
    for (int i = 0; i < n; i++) {
      double[] p = random.doubles(6, -1, 1).toArray();
      direct(ray, p[0], 1 + p[1], p[2], p[3] - p[0], p[4] - p[1], p[5] - p[2]);
      put(between, i, ray, Double.POSITIVE_INFINITY);
    }
    return List.of(
        new Rays("primary", false, primary),
        new Rays("diffuse", false, Arrays.copyOf(diffuse, SIZE * hits)),
        new Rays("shadow", true, Arrays.copyOf(shadow, SIZE * hits)),
        new Rays("random", false, between));
  }

  /** Sets a ray to leave a hit around its normal, more often the nearer to it (Lambert). */
  private static void scatter(Hit hit, SplittableRandom random, Ray ray) {
    double z = 2 * random.nextDouble() - 1;
    double angle = 2 * Math.PI * random.nextDouble();
    double r = Math.sqrt(1 - z * z);
    double dx = hit.nx + r * Math.cos(angle);
    double dy = hit.ny + r * Math.sin(angle);
    double dz = hit.nz + z;
    hit.spawn(dx, dy, dz, ray);
    direct(ray, ray.ox, ray.oy, ray.oz, dx, dy, dz);
  }

  private static double toLight(Hit hit, Ray ray) {
    hit.spawnTo(LIGHT[0], LIGHT[1], LIGHT[2], ray);
    double dx = LIGHT[0] - ray.ox;
    double dy = LIGHT[1] - ray.oy;
    double dz = LIGHT[2] - ray.oz;
    direct(ray, ray.ox, ray.oy, ray.oz, dx, dy, dz);
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  private static void direct(
      Ray ray, double ox, double oy, double oz, double dx, double dy, double dz) {
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    ray.set(ox, oy, oz, dx / length, dy / length, dz / length);
  }

  private static void put(double[] data, int i, Ray ray, double end) {
    double[] all = {ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, end};
    System.arraycopy(all, 0, data, SIZE * i, SIZE);
  }

  /** Writes them as big-endian floats, for a program in another language. */
  void write(Path file) throws IOException {
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file), 1 << 16))) {
      for (double v : data) {
        out.writeFloat((float) v);
      }
    }
  }
}

package glint.bench;

import glint.accel.Bvh;
import glint.accel.Intersector;
import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.math.Transform;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Prints how many million rays in a CPU second are traced through a mesh of a million triangles, of
 * four kinds, by Glint and by what peers are installed, in turns.
 */
public final class KernelTable {

  /** Rounds until everything is compiled, and rounds that count. */
  private static final int WARM_UP = 3;

  private static final int ROUNDS = 9;

  private KernelTable() {}

  /**
   * Prints the table.
   *
   * @param args the scene with the mesh, the commit, and the folder with the sources of peers in
   *     C++
   */
  public static void main(String[] args) throws IOException {
    float[] corners = DisplacedSphere.corners();
    Primitives primitives = flatten(corners);
    long began = System.nanoTime();
    Bvh tree = Bvh.over(primitives);
    double built = (System.nanoTime() - began) * 1e-9;
    List<Rays> all = Rays.of(new Intersector(tree));
    List<Kernel> kernels = new ArrayList<>();
    kernels.add(new GlintKernel(new Intersector(tree)));
    addSunflow(corners, kernels);
    EmbreeKernel.add(corners, all, Path.of(args[1]), kernels);
    System.out.printf(
        Locale.ROOT,
        "%d triangles, tree of %d nodes built in %.1f s; %s. Million rays per CPU second, median of"
            + " %d rounds.%n%n",
        primitives.count(),
        tree.nodes(),
        built,
        Machine.with(args[0]),
        ROUNDS);
    print(all, kernels, measure(all, kernels));
  }

  private static Primitives flatten(float[] corners) {
    double[] points = new double[corners.length];
    int[] numbers = new int[corners.length / 3];
    for (int i = 0; i < points.length; i++) {
      points[i] = corners[i];
      numbers[i / 3] = i / 3;
    }
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Mesh(points, numbers), Transform.IDENTITY, 0);
    return builder.build();
  }

  private static void addSunflow(float[] corners, List<Kernel> kernels) {
    try {
      Constructor<?> sunflow =
          Class.forName("glint.bench.SunflowKernel").getConstructor(float[].class);
      kernels.add((Kernel) sunflow.newInstance((Object) corners));
    } catch (ReflectiveOperationException e) {
      System.err.println("without Sunflow (Debian's package libsunflow-java): " + e);
    }
  }

  /** Rays per microsecond, by kernel, kind and round. */
  private static double[][][] measure(List<Rays> all, List<Kernel> kernels) throws IOException {
    double[][][] speeds = new double[kernels.size()][all.size()][ROUNDS];
    for (int round = -WARM_UP; round < ROUNDS; round++) {
      for (int kind = 0; kind < all.size(); kind++) {
        for (int k = 0; k < kernels.size(); k++) {
          Rays rays = all.get(kind);
          Kernel.Took took = kernels.get(k).trace(rays);
          if (round == -WARM_UP) {
            System.err.printf(
                Locale.ROOT,
                "%s, %s: %d of %d rays hit%n",
                kernels.get(k).name(),
                rays.kind(),
                took.hits(),
                rays.count());
          } else if (round >= 0) {
            speeds[k][kind][round] = rays.count() / took.seconds() * 1e-6;
          }
        }
      }
    }
    return speeds;
  }

  private static void print(List<Rays> all, List<Kernel> kernels, double[][][] speeds) {
    StringBuilder head = new StringBuilder("| |");
    for (Rays rays : all) {
      head.append(" ").append(rays.kind()).append(" |");
    }
    System.out.println(head);
    System.out.println("|---|" + "---|".repeat(all.size()));
    for (int k = 0; k < kernels.size(); k++) {
      StringBuilder row = new StringBuilder("| " + kernels.get(k).name() + " |");
      for (double[] rounds : speeds[k]) {
        Arrays.sort(rounds);
        row.append(String.format(Locale.ROOT, " %.2f |", rounds[ROUNDS / 2]));
      }
      System.out.println(row);
    }
  }
}

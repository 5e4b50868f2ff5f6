package glint.bench;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/**
 * Writes displaced-sphere.obj, an icosphere with bumps of five sizes, and a scene that shows it.
 *
 * <p>A frequency of n gives 20 n² triangles; 224, the default, a million. The model stands on the
 * ground around the axis y, its largest extent is 2, and its numbers are floats with nine digits,
 * as other renderers get them.
 */
public final class DisplacedSphere {

  private static final int FREQUENCY = 224;

  /** Waves in a unit of length, and how far they reach. */
  private static final double[][] BUMPS = {{3, .10}, {7, .06}, {15, .035}, {31, .018}, {63, .009}};

  private static final int[][] FACES = {
    {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
    {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}
  };

  private static final String SCENE =
      """
      # Made by ./gradlew -q :bench:displacedSphere --args=FOLDER
      scenes:
        displaced-sphere:
          title: A sphere with bumps, %d triangles
          image: {width: 800, height: 600}
          camera: {position: [1.2, 1.6, 3.6], look_at: [0, 0.95, 0], fov: 32}
          background: [0.4, 0.5, 0.7]
          lights:
            - point: {position: [3, 5, 2], color: 1}
          surfaces:
            - plane: {point: [0, 0, 0], normal: [0, 1, 0], material: {color: 0.6}}
            - mesh: {file: displaced-sphere.obj}
      """;

  private final int n;
  private final double[] points;
  private final int[] triangles;
  private final Map<Integer, int[]> edges = new HashMap<>();
  private int pointCount;
  private int triangleCount;

  private DisplacedSphere(int n) {
    this.n = n;
    points = new double[3 * (10 * n * n + 2)];
    triangles = new int[3 * 20 * n * n];
  }

  /** Writes both files into the folder that is the first argument; the second is the frequency. */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    int n = args.length > 1 ? Integer.parseInt(args[1]) : FREQUENCY;
    DisplacedSphere sphere = made(n);
    sphere.write(folder.resolve("displaced-sphere.obj"));
    String scene = SCENE.formatted(sphere.triangleCount);
    Files.writeString(folder.resolve("displaced-sphere.yaml"), scene);
  }

  private static DisplacedSphere made(int n) {
    DisplacedSphere sphere = new DisplacedSphere(n);
    sphere.divide();
    sphere.displace();
    sphere.normalize();
    return sphere;
  }

  /** Returns the corners of all triangles as the model has them, nine numbers each. */
  static float[] corners() {
    DisplacedSphere sphere = made(FREQUENCY);
    float[] corners = new float[3 * sphere.triangles.length];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = (float) sphere.points[3 * sphere.triangles[i / 3] + i % 3];
    }
    return corners;
  }

  /** Divides the faces of an icosahedron; those at an edge share its points. */
  private void divide() {
    double g = (1 + Math.sqrt(5)) / 2;
    for (double[] v :
        new double[][] {
          {-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
          {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}
        }) {
      point(v[0], v[1], v[2]);
    }
    for (int[] face : FACES) {
      int[] above = edge(face[0], face[1]);
      int[] beside = edge(face[0], face[2]);
      int[] opposite = edge(face[1], face[2]);
      int[] row = {face[0]};
      for (int i = 1; i <= n; i++) {
        int[] next = i < n ? between(above[i], beside[i], i) : opposite;
        for (int j = 0; j < i; j++) {
          triangle(row[j], next[j], next[j + 1]);
          if (j > 0) {
            triangle(row[j - 1], next[j], row[j]);
          }
        }
        row = next;
      }
    }
  }

  /** Returns the points of an edge from one corner to the other, made at its first use. */
  private int[] edge(int a, int b) {
    int[] forward = edges.get(100 * a + b);
    if (forward == null) {
      forward = between(a, b, n);
      int[] backward = new int[n + 1];
      for (int i = 0; i <= n; i++) {
        backward[n - i] = forward[i];
      }
      edges.put(100 * a + b, forward);
      edges.put(100 * b + a, backward);
    }
    return forward;
  }

  /** Returns a row of points in so many steps, its ends being there. */
  private int[] between(int a, int b, int steps) {
    int[] row = new int[steps + 1];
    row[0] = a;
    row[steps] = b;
    for (int i = 1; i < steps; i++) {
      double t = (double) i / steps;
      row[i] = point(mix(a, b, 0, t), mix(a, b, 1, t), mix(a, b, 2, t));
    }
    return row;
  }

  private double mix(int a, int b, int axis, double t) {
    double from = points[3 * a + axis];
    return from + (points[3 * b + axis] - from) * t;
  }

  private int point(double x, double y, double z) {
    points[3 * pointCount] = x;
    points[3 * pointCount + 1] = y;
    points[3 * pointCount + 2] = z;
    return pointCount++;
  }

  private void triangle(int a, int b, int c) {
    triangles[3 * triangleCount] = a;
    triangles[3 * triangleCount + 1] = b;
    triangles[3 * triangleCount + 2] = c;
    triangleCount++;
  }

  /** Moves the points onto the unit sphere and then along the radius. */
  private void displace() {
    for (int i = 0; i < points.length; i += 3) {
      double x = points[i];
      double y = points[i + 1];
      double z = points[i + 2];
      double length = Math.sqrt(x * x + y * y + z * z);
      double r = radius(x / length, y / length, z / length) / length;
      points[i] = x * r;
      points[i + 1] = y * r;
      points[i + 2] = z * r;
    }
  }

  private static double radius(double x, double y, double z) {
    double r = 1;
    for (double[] bump : BUMPS) {
      double k = bump[0];
      double sx = StrictMath.sin(k * x + 1.3 * k);
      double sz = StrictMath.sin(k * z + 2.1 * k);
      r += bump[1] * sx * StrictMath.sin(k * y + .7) * sz;
    }
    return r;
  }

  private void normalize() {
    double[] low = new double[3];
    double[] high = new double[3];
    for (int i = 0; i < points.length; i++) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
    double extent = 0;
    for (int axis = 0; axis < 3; axis++) {
      extent = Math.max(extent, high[axis] - low[axis]);
    }
    for (int i = 0; i < points.length; i++) {
      double origin = i % 3 == 1 ? low[1] : (low[i % 3] + high[i % 3]) / 2;
      points[i] = (points[i] - origin) * (2 / extent);
    }
  }

  private void write(Path file) throws IOException {
    try (PrintStream out =
        new PrintStream(
            new BufferedOutputStream(Files.newOutputStream(file), 1 << 16),
            false,
            StandardCharsets.US_ASCII)) {
      out.println("# displaced-sphere: " + pointCount + " points, " + triangleCount + " triangles");
      for (int i = 0; i < points.length; i += 3) {
        String xy = number(points[i]) + " " + number(points[i + 1]);
        out.println("v " + xy + " " + number(points[i + 2]));
      }
      for (int i = 0; i < triangles.length; i += 3) {
        int a = triangles[i] + 1;
        out.println("f " + a + " " + (triangles[i + 1] + 1) + " " + (triangles[i + 2] + 1));
      }
      if (out.checkError()) {
        throw new IOException(file + " could not be written");
      }
    }
  }

  private static String number(double v) {
    BigDecimal exact = new BigDecimal((float) v);
    return exact.round(new MathContext(9)).stripTrailingZeros().toPlainString();
  }
}

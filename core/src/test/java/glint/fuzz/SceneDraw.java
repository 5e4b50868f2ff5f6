package glint.fuzz;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.CornerValues;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Checker;
import glint.optics.Highlight;
import glint.optics.Material;
import glint.optics.Stripes;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Draws random scenes; counts what was refused. */
final class SceneDraw {

  /** The brightest colour: see {@link #inverseSquare}. */
  private static final double BRIGHTEST = 1e6;

  private Chance chance;
  private Extremes extremes;
  private List<FuzzScene.MeshNumbers> meshes;

  /** Parts drawn so far: surfaces, lights and cameras. */
  long drawn;

  /** Parts that their constructors refused. */
  long refused;

  FuzzScene draw(long seed) {
    chance = new Chance(seed);
    extremes = new Extremes(chance);
    meshes = new ArrayList<>();
    boolean bright = chance.oneIn(4);
    Scene.Builder scene = new Scene.Builder("fuzz").size(2, 2).camera(accepted(this::camera));
    int surfaces =
        switch (chance.below(16)) {
          case 0 -> chance.between(9, 50);
          case 1, 2, 3 -> chance.between(4, 12);
          default -> chance.between(1, 3);
        };
    for (int i = 0; i < surfaces; i++) {
      Material material = material(bright);
      scene.place(accepted(() -> placement(material)));
    }
    for (int lights = chance.below(4); lights > 0; lights--) {
      scene.light(accepted(this::light));
    }
    scene.background(new Background(extremes.color(BRIGHTEST), extremes.color(1)));
    scene.highlight(chance.oneIn(2) ? Highlight.BLINN : Highlight.PHONG);
    // Mirrors that amplify may do so a few times only: 1e6 to the power of 64 has no double.
    if (bright || chance.oneIn(2)) {
      scene.maxDepth(chance.below(6));
    }
    List<FuzzScene.Segment> rays = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      rays.add(new FuzzScene.Segment(extremes.point(), chance.of(extremes.points())));
    }
    return new FuzzScene(seed, scene.build(), meshes, rays);
  }

  private <T> T accepted(Supplier<T> part) {
    while (true) {
      drawn++;
      try {
        return part.get();
      } catch (BadValueException | ArithmeticException e) {
        refused++;
      }
    }
  }

  private Camera camera() {
    Vector3d position = extremes.point();
    Vector3d lookAt = extremes.point();
    double fov =
        chance.of(30, 90, 1e-3, Math.nextDown(180), Double.MIN_VALUE, 179.9, 180 * chance.unit());
    double aspect = chance.oneIn(4) ? extremes.size() : 0;
    double near = chance.oneIn(3) ? extremes.size() : 0;
    double far = chance.oneIn(3) ? extremes.size() : Double.POSITIVE_INFINITY;
    Projection lens = new Perspective(fov, chance.oneIn(2), aspect);
    Projection projection = chance.oneIn(4) ? new Orthographic(extremes.size()) : lens;
    return new Camera(position, lookAt, extremes.direction(), projection, near, far);
  }

  private Light light() {
    Rgb color = extremes.color(BRIGHTEST);
    return switch (chance.below(6)) {
      case 0 -> new Light.Ambient(color);
      case 1 -> new Light.Point(inverseSquare(extremes.point()), color, true);
      case 2 -> new Light.Directional(extremes.direction(), color);
      case 3 -> {
        double angle = chance.of(180, 1e-9, Double.MIN_VALUE, 180 * chance.unit());
        double softness = chance.of(0, 1, chance.unit(), Double.MIN_VALUE);
        yield new Light.Spot(extremes.point(), extremes.point(), color, angle, softness);
      }
      default -> new Light.Point(extremes.point(), color, false);
    };
  }

  /**
   * Moves a light to where its strength has a double: all coordinates 1e-100 or more.
   *
   * <p>A point that differs from it in a coordinate then differs by 1e-117 or more, so 1/d² is at
   * most 1e234, and with three colours and five mirrors of up to 1e6 at most 1e282. Nearer to the
   * origin, light of 1/d² may be more than a double holds, and rightly infinite.
   */
  private static Vector3d inverseSquare(Vector3d p) {
    return new Vector3d(outward(p.x()), outward(p.y()), outward(p.z()));
  }

  private static double outward(double v) {
    return Math.copySign(Math.max(Math.abs(v), 1e-100), v);
  }

  private Material material(boolean bright) {
    if (chance.oneIn(4)) {
      return Material.WHITE;
    }
    double greatest = bright ? BRIGHTEST : 1;
    double shininess = chance.of(0, 1, 32, 1e9, 1e9 * chance.unit(), Double.MIN_VALUE, 1000);
    Material plain =
        new Material(
            extremes.color(greatest),
            extremes.color(greatest),
            extremes.color(greatest),
            shininess,
            chance.oneIn(2) ? Rgb.BLACK : extremes.color(greatest),
            chance.oneIn(2) ? Rgb.BLACK : extremes.color(greatest));
    double size = Math.min(Math.max(extremes.size(), Check.SMALLEST), Check.LARGEST);
    return switch (chance.below(4)) {
      case 0 -> plain.textured(new Checker(size, Rgb.BLACK, extremes.color(1)));
      case 1 -> plain.textured(new Stripes(size, extremes.color(1), Rgb.WHITE));
      default -> plain;
    };
  }

  private Placement placement(Material material) {
    Surface surface = surface();
    Transform toWorld = chance.oneIn(2) ? Transform.IDENTITY : extremes.transform();
    return new Placement(surface, toWorld, material);
  }

  private Surface surface() {
    Extremes e = extremes;
    return switch (chance.below(12)) {
      case 0, 1, 2 -> new Sphere(e.point(), e.size());
      case 3 -> new Triangle(e.point(), e.point(), e.point());
      case 4 -> sliver();
      case 5 -> new Plane(e.point(), e.direction());
      case 6 -> new Quad(e.point(), e.direction(), e.direction());
      case 7 -> box(e.point(), e.point());
      case 8 -> new Pyramid(e.point(), List.of(e.point(), e.point(), e.point(), e.point()));
      case 9, 10 -> cylinder();
      default -> meshes.isEmpty() || chance.oneIn(2) ? mesh() : meshes.get(0).mesh();
    };
  }

  /** A triangle of three points nearly or exactly in line. */
  private Triangle sliver() {
    Vector3d a = extremes.point();
    Vector3d b = extremes.point();
    double s = chance.of(0.5, 1, 2, chance.unit());
    Vector3d c = a.times(1 - s).plus(b.times(s));
    return chance.oneIn(2)
        ? new Triangle(a, b, c)
        : new Triangle(a, b, new Vector3d(Math.nextUp(c.x()), c.y(), c.z()));
  }

  private Box box(Vector3d a, Vector3d b) {
    Vector3d most = new Vector3d(above(a.x(), b.x()), above(a.y(), b.y()), above(a.z(), b.z()));
    return new Box(
        new Vector3d(Math.min(a.x(), b.x()), Math.min(a.y(), b.y()), Math.min(a.z(), b.z())), most);
  }

  /** Returns the larger one, or what is just above both. */
  private double above(double a, double b) {
    double more = chance.oneIn(2) ? Math.nextUp(a) : a + extremes.size();
    return a == b ? more : Math.max(a, b);
  }

  private Cylinder cylinder() {
    Vector3d base = extremes.point();
    double size = extremes.size();
    Vector3d top = chance.oneIn(2) ? extremes.point() : extremes.offset(base, size);
    double radius = chance.oneIn(5) ? 0 : extremes.size();
    double topRadius = chance.oneIn(3) ? radius : chance.oneIn(2) ? 0 : extremes.size();
    return new Cylinder(base, top, radius, topRadius, chance.oneIn(2));
  }

  /** Normals that point anywhere, and corners without. */
  private CornerValues normals(int corners) {
    double[] values = new double[9];
    for (int i = 0; i < 9; i++) {
      values[i] = chance.oneIn(4) ? 0 : chance.oneIn(2) ? extremes.size() : -extremes.size();
    }
    int[] indices = new int[corners];
    for (int i = 0; i < corners; i++) {
      indices[i] = chance.below(4) - 1;
    }
    return new CornerValues(3, values, indices);
  }

  private Mesh mesh() {
    int count = chance.between(3, 6);
    double[] points = new double[3 * count];
    for (int i = 0; i < count; i++) {
      Vector3d p = extremes.point();
      points[3 * i] = p.x();
      points[3 * i + 1] = p.y();
      points[3 * i + 2] = p.z();
    }
    int[] corners = new int[3 * chance.between(1, 5)];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = chance.oneIn(2) ? i % count : chance.below(count);
    }
    Mesh mesh = new Mesh(points, corners);
    if (chance.oneIn(2)) {
      mesh = mesh.withNormals(normals(corners.length), new int[corners.length / 3]);
    }
    meshes.add(new FuzzScene.MeshNumbers(mesh, points, corners));
    return mesh;
  }
}

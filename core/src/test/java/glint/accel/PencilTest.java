package glint.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Hit;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Primitives;
import glint.geometry.Quad;
import glint.geometry.Ray;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Rays of a pencil find in their lists what a scan of everything finds, bit for bit. */
class PencilTest {

  private static final double BEFORE_ONE = Math.nextDown(1.0);

  private final Ray ray = new Ray();
  private final Hit a = new Hit();
  private final Hit b = new Hit();
  private int listed;
  private int hits;

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static Vector3d random(Random r, double scale) {
    return v(r.nextGaussian() * scale, r.nextGaussian() * scale, r.nextGaussian() * scale);
  }

  /** Surfaces of every kind, some turned and flattened, some that move, some instances. */
  private static Primitives soup(Random r, int count, double scale) {
    Primitives.Builder builder = new Primitives.Builder();
    double[] corners = {-1, -1, 0, 1, -1, 0, 0, 1, 0.5, 0, -1, 1};
    Mesh mesh = new Mesh(corners, new int[] {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 2, 3});
    Transform unit = Transform.scale(v(scale, scale, scale));
    for (int i = 0; i < count; i++) {
      double size = StrictMath.pow(10, -4 * r.nextDouble());
      Transform put = Transform.translate(random(r, 1)).then(unit);
      Transform flat =
          Transform.scale(v(size, 0.01 * size, size))
              .then(Transform.rotate(Quaternion.aboutAxis(random(r, 1), 360 * r.nextDouble())));
      if (r.nextInt(8) == 0) {
        builder.show(mesh, flat.then(put), i, false);
      } else {
        Surface shape = shape(r, r.nextInt(6), size);
        builder.add(shape, r.nextInt(4) == 0 ? flat.then(put) : put, i);
      }
      if (r.nextInt(6) == 0) {
        builder.move(i, 1, random(r, 0.2 * scale));
      }
    }
    return builder.build();
  }

  private static Surface shape(Random r, int kind, double size) {
    return switch (kind) {
      case 0 -> new Sphere(Vector3d.ZERO, size);
      case 1 -> new Box(v(-size, -size, -size), v(size, 0.5 * size, size));
      case 2 -> new Cylinder(Vector3d.ZERO, random(r, size), size, 0.3 * size, true);
      case 3 -> new Triangle(random(r, size), random(r, size), random(r, size));
      case 4 -> new Quad(Vector3d.ZERO, v(size, 0, 0), v(0, 0, size));
      default ->
          r.nextInt(9) == 0
              ? new Plane(random(r, 1), random(r, 1))
              : new Sphere(Vector3d.ZERO, size);
    };
  }

  /** A place that is likely to be where something begins or ends: a corner of a box, or near it. */
  private static Vector3d corner(Random r, Primitives primitives) {
    double[] box = new double[6];
    int bounded = primitives.count() - primitives.unbounded();
    primitives.bounds(primitives.unbounded() + r.nextInt(bounded), box);
    double[] at = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double share = r.nextInt(3) / 2.0;
      at[axis] = box[axis] + share * (box[3 + axis] - box[axis]);
      at[axis] += (r.nextInt(5) - 2) * Math.ulp(at[axis]);
    }
    return v(at[0], at[1], at[2]);
  }

  /** Where rays begin or end: anywhere, within something, at its edge, on an axis, far away. */
  private static Vector3d end(Random r, Primitives primitives, double scale) {
    return switch (r.nextInt(5)) {
      case 0 -> random(r, scale);
      case 1 -> random(r, 3 * scale);
      case 2 -> corner(r, primitives);
      case 3 -> v(0, 5 * scale, 0);
      default -> random(r, 1000 * scale);
    };
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "2, 1",
    "5, 1",
    "12, 1",
    "40, 1",
    "300, 1",
    "12, 0x1p-300",
    "12, 0x1p300",
    "40, 0x1p-40"
  })
  void listsFindWhatAScanFinds(int count, String power) {
    double scale = Double.parseDouble(power);
    Random r = new Random(count);
    int worlds = count < 100 ? 60 : 4;
    for (int world = 0; world < worlds; world++) {
      Primitives soup = soup(r, count, scale);
      if (soup.count() > soup.unbounded()) {
        Bvh tree = Bvh.over(soup);
        for (int k = 0; k < 3; k++) {
          fromAndTo(r, tree, scale);
          along(r, tree, scale);
        }
      }
    }
    assertTrue(listed > 60 * worlds, "listed: " + listed);
    assertTrue(hits > 60 * worlds, "hits: " + hits);
  }

  /** A few subtrees, or all leaves, or nothing. */
  private static Parts parts(Random r, Bvh tree) {
    int most = 2 + (int) StrictMath.pow(1000, r.nextDouble());
    return tree.nodes() == 0 || r.nextInt(3) == 0 ? null : Parts.of(tree, most);
  }

  private void fromAndTo(Random r, Bvh tree, double scale) {
    Vector3d p = end(r, tree.primitives(), scale);
    Parts parts = parts(r, tree);
    Pencil from = Pencil.from(p, tree.primitives(), parts);
    Pencil to = Pencil.to(p, tree.primitives(), parts);
    Intersector search = new Intersector(tree);
    Intersector scan = new Intersector(tree.primitives());
    for (int i = 0; i < 100; i++) {
      Vector3d q = r.nextInt(3) == 0 ? random(r, scale) : corner(r, tree.primitives());
      ray.time = r.nextDouble();
      Vector3d away = q.minus(p);
      if (away.maxAbs() == 0) {
        continue;
      }
      Vector3d d = r.nextBoolean() ? away.normalized() : near(away);
      ray.set(p.x(), p.y(), p.z(), d.x(), d.y(), d.z());
      agree(scan, search, from, Double.POSITIVE_INFINITY);
      if (b.found()) { // as rays leave a surface for a light
        scan.resolve(ray, b);
        b.face(ray);
        double end = b.spawnTo(p.x(), p.y(), p.z(), ray);
        agree(scan, search, to, end);
      }
      Vector3d o = p.plus(away.times(1 + 2 * r.nextDouble() * far(r)));
      Vector3d back = near(p.minus(o));
      ray.set(o.x(), o.y(), o.z(), back.x(), back.y(), back.z());
      agree(scan, search, to, BEFORE_ONE * p.minus(o).maxAbs() / back.maxAbs());
    }
  }

  /** How many times as far as things are rays begin, often so far that they have few lists. */
  private static double far(Random r) {
    return StrictMath.pow(2, r.nextInt(2) * 18 * r.nextDouble());
  }

  /** A power of two times a vector, of length 1 to 4, as directions of shadow rays are. */
  private static Vector3d near(Vector3d v) {
    return v.times(Math.scalb(1.0, -Math.getExponent(v.maxAbs())));
  }

  private void along(Random r, Bvh tree, double scale) {
    Vector3d d = r.nextInt(3) == 0 ? v(0, -1, 0) : random(r, 1).normalized();
    Pencil pencil = Pencil.along(d, tree.primitives(), parts(r, tree));
    Intersector search = new Intersector(tree);
    Intersector scan = new Intersector(tree.primitives());
    for (int i = 0; i < 100; i++) {
      Vector3d q = r.nextInt(3) == 0 ? random(r, scale) : corner(r, tree.primitives());
      Vector3d o = q.minus(d.times(scale * far(r) * (4 * r.nextDouble() - 1)));
      ray.time = r.nextDouble();
      ray.set(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
      agree(scan, search, pencil, r.nextBoolean() ? Double.POSITIVE_INFINITY : scale);
    }
  }

  /** Compares searches of a ray; leaves what the scan found. */
  private void agree(Intersector scan, Intersector search, Pencil pencil, double end) {
    listed += pencil.list(ray) == Cells.MANY ? 0 : 1;
    search.closest(ray, end, pencil, a);
    scan.closest(ray, end, b);
    assertEquals(b.primitive, a.primitive);
    assertEquals(b.t, a.t);
    int blocker = search.blocker(ray, end, pencil, -1, a);
    assertEquals(b.found(), blocker >= 0);
    hits += b.found() ? 1 : 0;
  }

  /** Whatever ray is asked for, what it is not one of is searched for as without a pencil. */
  @Test
  void raysOfOtherPencilsHaveNoList() {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Sphere(Vector3d.ZERO, 1), Transform.IDENTITY, 0);
    Primitives ball = builder.build();
    Vector3d p = v(3, 4, 5);
    ray.set(3, 4, 5, -1, 0, 0);
    assertNotEquals(Cells.MANY, Pencil.from(p, ball, null).list(ray));
    ray.set(3, 4, Math.nextUp(5.0), -1, 0, 0);
    assertEquals(Cells.MANY, Pencil.from(p, ball, null).list(ray));
    ray.set(3, 4, 5, 3, 4, 5);
    assertNotEquals(Cells.MANY, Pencil.along(p, ball, null).list(ray));
    ray.set(3, 4, 5, 3, Math.nextUp(4.0), 5);
    assertEquals(Cells.MANY, Pencil.along(p, ball, null).list(ray));
    for (double far : new double[] {1e9, Double.POSITIVE_INFINITY, Double.NaN}) {
      ray.set(far, 4, 5, -1, 0, 0);
      assertEquals(Cells.MANY, Pencil.to(p, ball, null).list(ray));
      ray.set(far, 4, 5, 3, 4, 5);
      assertEquals(Cells.MANY, Pencil.along(p, ball, null).list(ray));
    }
  }

  /** Balls at distance 4 are seen in a cell of one face; fifteen have a list, but not sixteen. */
  @Test
  void listsHoldWhatIsSeenInACell() {
    Primitives.Builder builder = new Primitives.Builder();
    for (int i = 0; i < 16; i++) {
      builder.add(new Sphere(v(4, 0, 0), 0.1), Transform.IDENTITY, i);
      builder.add(
          new Sphere(v(0, i < 15 ? 4 : 9, i < 15 ? 0 : 9), 0.1), Transform.IDENTITY, 16 + i);
    }
    builder.add(new Plane(v(0, -1, 0), v(0, 1, 0)), Transform.IDENTITY, 32);
    Pencil pencil = Pencil.from(Vector3d.ZERO, builder.build(), null);
    assertEquals(Cells.MANY, list(pencil, v(1, 0, 0)));
    assertEquals(15, Cells.length(list(pencil, v(0, 1, 0))));
    assertEquals(0, Cells.length(list(pencil, v(1, 0.9, 0))));
    assertEquals(0, Cells.length(list(pencil, v(-1, 0, 0))));
    int one = list(pencil, v(0, 1, 1));
    assertEquals(1, Cells.length(one));
    assertEquals(32, pencil.slot(Cells.start(one)));
  }

  private int list(Pencil pencil, Vector3d d) {
    ray.set(0, 0, 0, d.x(), d.y(), d.z());
    return pencil.list(ray);
  }
}

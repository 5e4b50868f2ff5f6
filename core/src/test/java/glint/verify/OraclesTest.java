package glint.verify;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Triangle;
import glint.math.Vector3d;
import glint.verify.HardCase.Effort;
import java.math.BigDecimal;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The judges are judged: known answers, and wrong ones that they have to notice. */
class OraclesTest {

  private static final Vector3d X = new Vector3d(1, 0, 0);

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  private static double[] parameters(Oracle oracle, Vector3d o, Vector3d d) {
    return oracle.crossings(o, d).stream()
        .filter(c -> c.inside() >= 0)
        .mapToDouble(c -> Exact.toDouble(c.t()))
        .sorted()
        .toArray();
  }

  @Test
  void rootsHaveSixtyDigits() {
    String root = "1.41421356237309504880168872420969807856967187537694807317668";
    assertEquals(0, Exact.sqrt(new BigDecimal(2)).compareTo(new BigDecimal(root)));
    assertEquals(
        new BigDecimal("1E-200"), Exact.sqrt(new BigDecimal("1E-400")).stripTrailingZeros());
    assertEquals(0, Exact.sqrt(Exact.of(0x1p200)).compareTo(Exact.of(0x1p100)));
    assertEquals(BigDecimal.ZERO, Exact.sqrt(new BigDecimal("0.00")));
  }

  @Test
  void doublesComeBackToWithinTwoUlp() {
    Dice dice = new Dice(1);
    for (int i = 0; i < 10_000; i++) {
      double v = dice.sign() * dice.log(1e-150, 1e150);
      assertEquals(v, Exact.toDouble(Exact.of(v)), 2 * Math.ulp(v));
      BigDecimal third = Exact.ratio(Exact.of(v), new BigDecimal(3));
      assertEquals(v / 3, Exact.toDouble(third), 3 * Math.ulp(v / 3));
    }
    assertEquals(0, Exact.toDouble(new BigDecimal("0.000")));
  }

  @Test
  void everyOracleKnowsItsShape() {
    Sphere sphere = new Sphere(Vector3d.ZERO, 5);
    assertArrayEquals(
        new double[] {6, 14}, parameters(new SphereOracle(sphere), v(-10, 3, 0), X), 1e-14);
    Plane plane = new Plane(v(2, 7, 7), v(-3, 0, 0));
    assertArrayEquals(
        new double[] {0.5}, parameters(new PlaneOracle(plane), v(1, 0, 0), v(2, 9, 9)), 1e-14);
    Box box = new Box(v(-1, -1, -1), v(1, 1, 1));
    assertArrayEquals(
        new double[] {2, 3}, parameters(new BoxOracle(box), v(-3, -2, 0), v(1, 1, 0)), 1e-14);
    Triangle triangle = new Triangle(v(1, 0, 0), v(1, 2, 0), v(1, 0, 2));
    assertArrayEquals(
        new double[] {4},
        parameters(new TriangleOracle(triangle), v(-3, 1, 1), X),
        1e-14,
        "on an edge");
    assertEquals(0, parameters(new TriangleOracle(triangle), v(-3, 1.01, 1), X).length);
    Cylinder cylinder = new Cylinder(Vector3d.ZERO, v(0, 2, 0), 5, 5, true);
    CylinderOracle round = new CylinderOracle(cylinder);
    assertArrayEquals(new double[] {6, 14}, parameters(round, v(-10, 1, 3), X), 1e-14);
    assertArrayEquals(new double[] {1, 3}, parameters(round, v(0, -1, 3), v(0, 1, 0)), 1e-14);
    Cylinder cone = new Cylinder(Vector3d.ZERO, v(0, 4, 0), 2, 0, false);
    CylinderOracle pointed = new CylinderOracle(cone);
    assertArrayEquals(new double[] {9, 11}, parameters(pointed, v(-10, 2, 0), X), 1e-14);
    assertArrayEquals(new double[] {2}, parameters(pointed, v(1, 0, 0), v(0, 1, 0)), 1e-14);
  }

  @Test
  void wrongDecisionsAreMeasured() {
    SphereOracle sphere = new SphereOracle(new Sphere(Vector3d.ZERO, 1));
    double unit = 0x1p-53 * (Math.sqrt(101) + 1);
    List<Crossing> past = sphere.crossings(v(-10, 1 + 0x1p-45, 0), X);
    assertEquals(0, Crossing.wrongness(past, false, 0, 16));
    assertEquals(0x1p-45 / unit, Crossing.wrongness(past, true, 10, 16), 1e-6);
    List<Crossing> through = sphere.crossings(v(-10, 0.5, 0), X);
    double near = 10 - Math.sqrt(0.75);
    assertEquals(0, Crossing.wrongness(through, true, near, 16));
    assertTrue(Crossing.error(through, near) < 2);
    assertTrue(Crossing.wrongness(through, false, 0, 16) > 1e14, "a miss");
    assertTrue(Crossing.wrongness(through, true, 10 + Math.sqrt(0.75), 16) > 1e14, "the far root");
    assertEquals(Double.POSITIVE_INFINITY, Crossing.wrongness(through, true, 9, 16));
    List<Crossing> behind = sphere.crossings(v(10, 0.5, 0), X);
    assertTrue(Crossing.wrongness(behind, true, -near, 16) > 1e14, "behind the eye");
  }

  @Test
  void aKernelThatIsOffFailsItsRow() {
    // Spheres a trifle larger than their oracle believes.
    Adversary<Sphere> off =
        new Adversary<>(
            "sphere",
            dice -> new Sphere(dice.cube(1), 1 + 0x1p-40),
            s -> new SphereOracle(new Sphere(s.center(), 1)),
            (dice, s) -> new Adversary.Spot(s.center().plus(dice.unit()), dice.unit(), 1),
            SphereOracle.DECISION,
            SphereOracle.PARAMETER);
    Tally tally = new Tally(Effort.SHORT);
    off.attack(
        new Dice(1),
        1000,
        sphere -> {
          Shoot shoot = Shoot.at(sphere);
          Oracle oracle = off.oracle().apply(sphere);
          return (o, d) -> {
            boolean found = shoot.from(o, d);
            tally.check(Crossing.wrongness(oracle.crossings(o, d), found, shoot.hit.t, 16) <= 4);
          };
        });
    assertTrue(tally.wrong() > 100, "wrong: " + tally.wrong());
  }

  @Test
  void meshesAreClosed() {
    for (ClosedMesh mesh :
        List.of(ClosedMesh.globe(2, 20, 40), ClosedMesh.cube(1), ClosedMesh.hills(2))) {
      Map<List<Integer>, Integer> edges = new HashMap<>();
      for (int[] f : mesh.faces()) {
        for (int i = 0; i < 3; i++) {
          int a = f[i];
          int b = f[(i + 1) % 3];
          edges.merge(List.of(Math.min(a, b), Math.max(a, b)), 1, Integer::sum);
        }
      }
      assertTrue(edges.values().stream().allMatch(n -> n == 2));
      assertEquals(2, mesh.corners().size() - edges.size() + mesh.faces().size(), "Euler");
    }
    assertEquals(1520, ClosedMesh.globe(2, 20, 40).faces().size());
    assertEquals(20 * 256, ClosedMesh.hills(4).faces().size());
  }
}

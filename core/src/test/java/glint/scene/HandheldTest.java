package glint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.math.BadValueException;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.Optional;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class HandheldTest {

  private static final int W = 320;
  private static final int H = 200;

  /** What a few dozen roundings may do to a direction, or to a length of 1. */
  private static final double CLOSE = 0x1p-46;

  /** A camera by hand that stands anywhere, looks anywhere and is held anyhow. */
  @Provide
  Arbitrary<Handheld> held() {
    Arbitrary<Double> some = Arbitraries.doubles().between(-1, 1);
    Arbitrary<Vector3d> points = Combinators.combine(some, some, some).as(Vector3d::new);
    Arbitrary<Quaternion> turns =
        Combinators.combine(some, some, some)
            .as((x, y, z) -> new Quaternion(0.01, x, y, z))
            .edgeCases(c -> c.add(new Quaternion(1, 1, 0, 0)).add(new Quaternion(1, -1, 0, 0)));
    Arbitrary<Projection> lenses =
        Arbitraries.of(
            Projection.vertical(40), new Perspective(70, true, 1.3), new Orthographic(3));
    return Combinators.combine(points, turns, Arbitraries.doubles().between(0.1, 30), lenses)
        .as((target, turn, distance, lens) -> held(target, turn, distance, lens));
  }

  private static Handheld held(Vector3d target, Quaternion turn, double distance, Projection lens) {
    Transform t = Transform.rotate(turn);
    Vector3d eye = target.plus(t.direction(new Vector3d(0, 0, distance)));
    Vector3d up = t.direction(new Vector3d(0, 2, 1));
    return new Handheld(Camera.of(eye, target, up, lens), W, H);
  }

  /** Seen from the front, at a distance of 5, on a ball of 100 pixels. */
  private static Handheld front() {
    Camera front = looking(new Vector3d(0, 0, 5), Vector3d.ZERO);
    return new Handheld(front, W, H);
  }

  private static Camera looking(Vector3d from, Vector3d to) {
    return Camera.of(from, to, new Vector3d(0, 1, 0), Projection.vertical(40));
  }

  private static double distance(Camera c) {
    return c.position().minus(c.lookAt()).length();
  }

  private static void assertNear(Vector3d expected, Vector3d actual, double size) {
    assertEquals(0, expected.minus(actual).length(), CLOSE * size, expected + " not " + actual);
  }

  /** Checks that two cameras are the same, but for the rounding of coordinates of some size. */
  private static void assertSame(Camera expected, Camera actual, double size) {
    double direction = 1 + size / distance(expected);
    assertNear(expected.position(), actual.position(), size * direction);
    assertNear(expected.lookAt(), actual.lookAt(), size * direction);
    assertNear(new View(expected, W, H).up(), new View(actual, W, H).up(), direction);
  }

  private static double size(Camera c) {
    return c.position().maxAbs() + c.lookAt().maxAbs();
  }

  /** Checks where in a camera's picture a point is, within a ten-thousandth of a pixel. */
  private static void assertSeen(double column, double row, Vector3d point, Camera by) {
    double[] out = new double[2];
    new View(by, W, H).project(point.x(), point.y(), point.z(), out);
    assertEquals(column, out[0], 1e-4);
    assertEquals(row, out[1], 1e-4);
  }

  @Test
  void aDragTurnsByTwiceItsArc() {
    // Half a radius to the right is an arc of 30 degrees: the world turns by 60, the eye to -60.
    Camera left = front().orbited(160, 100, 210, 100);
    double s = StrictMath.sqrt(0.75);
    assertNear(new Vector3d(-5 * s, 0, 2.5), left.position(), 5);
    assertNear(new Vector3d(0, 1, 0), left.up(), 1);
    // All of the radius down is a right angle: the world turns half, about the x axis.
    Camera behind = front().orbited(160, 100, 160, 200);
    assertNear(new Vector3d(0, 0, -5), behind.position(), 5);
    assertNear(new Vector3d(0, -1, 0), behind.up(), 1);
    Camera below = front().orbited(160, 100, 160, 100 - 100 * StrictMath.sqrt(0.5));
    assertNear(new Vector3d(0, -5, 0), below.position(), 5);
    assertNear(new Vector3d(0, 0, 1), below.up(), 1);
  }

  @Test
  void aDragOutsideOfTheBallRolls() {
    Camera rolled = front().orbited(310, 100, 160, 250);
    assertNear(new Vector3d(0, 0, 5), rolled.position(), 5);
    assertNear(new Vector3d(0, -1, 0), rolled.up(), 1);
    assertSame(front().rolled(180), rolled, 5);
  }

  /** Up and up, four times round, over every pole on the way: each step is like the first. */
  @Property(tries = 20)
  void noDirectionIsSpecial(@ForAll("held") Handheld held) {
    Camera camera = held.camera();
    Vector3d right = new View(camera, W, H).right();
    double turn = 4 * StrictMath.asin(0.01); // about the middle, half the way on either side
    for (int i = 0; i < 4 * 157; i++) {
      Camera next = new Handheld(camera, W, H).orbited(160, 101, 160, 99);
      Vector3d before = new View(camera, W, H).forward();
      Vector3d after = new View(next, W, H).forward();
      assertEquals(StrictMath.sin(turn), before.cross(after).length(), 1e-12);
      assertNear(right, new View(next, W, H).right(), 1 + i);
      camera = next;
    }
    assertEquals(distance(held.camera()), distance(camera), 628 * CLOSE * distance(camera));
  }

  @Property
  void dragsAddUpAndLeadBack(
      @ForAll("held") Handheld held,
      @ForAll @DoubleRange(min = 0, max = W) double x,
      @ForAll @DoubleRange(min = -H, max = H) double y) {
    Camera first = held.orbited(100, 120, x, y);
    Camera second = new Handheld(first, W, H).orbited(x, y, 222, 33);
    double size = size(held.camera()) + size(first) + size(second);
    assertSame(held.orbited(100, 120, 222, 33), second, size);
    assertSame(held.camera(), new Handheld(second, W, H).orbited(222, 33, 100, 120), size);
    assertEquals(held.camera().lookAt(), first.lookAt());
  }

  @Property
  void whatIsAsFarAsTheTargetFollowsAPan(
      @ForAll("held") Handheld held,
      @ForAll @DoubleRange(min = -500, max = 500) double columns,
      @ForAll @DoubleRange(min = -500, max = 500) double rows) {
    Camera panned = held.panned(columns, rows);
    Vector3d target = held.camera().lookAt();
    assertSeen(W / 2.0 + columns, H / 2.0 + rows, target, panned);
    assertEquals(distance(held.camera()), distance(panned), 1e-12 * (1 + distance(panned)));
    double size = size(held.camera()) + size(panned);
    assertSame(held.camera(), new Handheld(panned, W, H).panned(-columns, -rows), size);
  }

  @Property
  void rollingTurnsThePictureClockwise(
      @ForAll("held") Handheld held, @ForAll @DoubleRange(min = -360, max = 360) double degrees) {
    double[] before = new double[2];
    View view = new View(held.camera(), H, H);
    Vector3d point = held.camera().lookAt().plus(view.right().times(0.01)).plus(view.up());
    view.project(point.x(), point.y(), point.z(), before);
    double[] after = new double[2];
    Camera rolled = new Handheld(held.camera(), H, H).rolled(degrees);
    new View(rolled, H, H).project(point.x(), point.y(), point.z(), after);
    if (!(held.camera().projection() instanceof Perspective p && p.aspect() != 0)) {
      double cos = StrictMath.cos(StrictMath.toRadians(degrees));
      double sin = StrictMath.sin(StrictMath.toRadians(degrees));
      double x = before[0] - H / 2.0;
      double y = before[1] - H / 2.0;
      double close = 1e-9 * (Math.abs(x) + Math.abs(y));
      assertEquals(H / 2.0 + x * cos - y * sin, after[0], close);
      assertEquals(H / 2.0 + x * sin + y * cos, after[1], close);
    }
    assertNear(held.camera().position(), rolled.position(), 40);
  }

  @Property
  void aDollyChangesTheDistanceAlone(
      @ForAll("held") Handheld held, @ForAll @DoubleRange(min = 0.1, max = 8) double factor) {
    Camera camera = held.camera();
    Camera moved = held.dollied(factor);
    assertEquals(camera.lookAt(), moved.lookAt());
    if (camera.projection() instanceof Orthographic parallel) {
      assertEquals(camera.position(), moved.position());
      assertEquals(new Orthographic(factor * parallel.planeHeight()), moved.projection());
    } else {
      assertEquals(factor * distance(camera), distance(moved), 1e-13 * (1 + distance(moved)));
      Vector3d forward = new View(camera, W, H).forward();
      assertEquals(0, forward.minus(new View(moved, W, H).forward()).length(), 1e-13);
    }
  }

  @Property
  void theTargetComesToTheMiddleByTheShortestWay(
      @ForAll("held") Handheld held,
      @ForAll @DoubleRange(min = -9, max = 9) double x,
      @ForAll @DoubleRange(min = -9, max = 9) double y) {
    Camera camera = held.camera();
    Vector3d point = new Vector3d(x, y, 4);
    Camera aimed = held.aimed(point);
    assertEquals(point, aimed.lookAt());
    Vector3d before = new View(camera, W, H).forward();
    Vector3d after = new View(aimed, W, H).forward();
    if (camera.projection() instanceof Orthographic) {
      assertEquals(0, before.minus(after).length(), 1e-13);
      assertEquals(distance(camera), distance(aimed), 1e-13 * (30 + distance(aimed)));
    } else {
      assertEquals(camera.position(), aimed.position());
    }
    Vector3d axis = before.cross(after);
    assertEquals(new View(camera, W, H).up().dot(axis), aimed.up().dot(axis), 1e-12);
    assertEquals(0, aimed.up().dot(after), 1e-12);
  }

  @Test
  void whatIsBehindIsATargetToo() {
    Camera back = front().aimed(new Vector3d(0, 0, 9));
    assertEquals(new Vector3d(0, 0, 5), back.position());
    assertNear(new Vector3d(0, 1, 0), back.up(), 1);
  }

  @Test
  void aTargetInFocusStaysSo() {
    Camera front = front().camera();
    Lens lens = new Lens(0.1, 5);
    Handheld held =
        new Handheld(
            new Camera(
                front.position(),
                front.lookAt(),
                front.up(),
                front.projection(),
                1,
                20,
                Optional.of(lens)),
            W,
            H);
    assertEquals(Optional.of(lens), held.orbited(1, 2, 3, 4).lens().map(l -> rounded(l)));
    assertEquals(Optional.of(new Lens(0.1, 2.5)), held.dollied(0.5).lens());
    assertEquals(Optional.of(new Lens(0.1, 13)), held.aimed(new Vector3d(12, 0, 0)).lens());
    assertEquals(1, held.panned(3, 4).near());
    assertEquals(20, held.panned(3, 4).far());
  }

  private static Lens rounded(Lens lens) {
    return new Lens(lens.radius(), Math.rint(lens.focus() * 1e12) / 1e12);
  }

  @Test
  void noMoveLeavesTheRangeOfCoordinates() {
    assertThrows(BadValueException.class, () -> front().dollied(0));
    assertThrows(BadValueException.class, () -> front().dollied(1e200));
    assertThrows(BadValueException.class, () -> front().panned(1e200, 0));
    assertThrows(BadValueException.class, () -> front().aimed(new Vector3d(0, 0, 5)));
  }
}

package glint.verify;

import glint.color.Rgb;
import glint.geometry.Quad;
import glint.light.Light;
import glint.math.Quaternion;
import glint.math.Rounding;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Aov;
import glint.render.RenderResult;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;

/** What may not change a picture: scale, order, place, threads and tiles. */
final class WorldCases {

  private WorldCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("B12", "threads and tiles change no bit of a picture", WorldCases::order),
        HardCase.exact("Q11", "world·2^k, k in -40..40: no bit changes", WorldCases::powers),
        HardCase.exact("Q11-clear", "glass and patterns ·2^k: no bit", WorldCases::clearPowers),
        HardCase.exact("Q01", "turned by q and by -q: no bit changes", WorldCases::turned),
        HardCase.exact("A27-mirrored", "glass and patterns mirrored in x", WorldCases::mirrored),
        HardCase.exact("A27-permuted", "surfaces in another order: no bit", WorldCases::permuted),
        HardCase.exact("A27-ids", "dyadic moves: ids and t, bit for bit", WorldCases::movedIds),
        HardCase.within(
            "A27-moved", "dyadic moves: radiance", MOVED, "u·|move|/D", WorldCases::movedRadiance),
        HardCase.within("A27-split", "a quad in quarters", 1e-12, "radiance", WorldCases::split));
  }

  /** Counts the pixels of two pictures, and as wrong those that differ in any bit. */
  static void compare(double[] a, double[] b, Tally tally) {
    for (int i = 0; i < a.length; i += 3) {
      tally.check(a[i] == b[i] && a[i + 1] == b[i + 1] && a[i + 2] == b[i + 2]);
    }
  }

  private static void order(Tally tally) {
    Scene scene = SampleWorld.PLAIN.scene().build();
    double[] first = Pictures.render(scene, 4, 1, 32, Set.of()).image().rgb();
    for (int threads : new int[] {1, 2, 8}) {
      for (int tile : new int[] {8, 32, 1000}) {
        compare(first, Pictures.render(scene, 4, threads, tile, Set.of()).image().rgb(), tally);
      }
    }
  }

  private static void powers(Tally tally) {
    double[] plain = Pictures.pixels(SampleWorld.PLAIN.scene());
    for (int k = -40; k <= 40; k++) {
      SampleWorld scaled = SampleWorld.scaled(Math.scalb(1.0, k));
      compare(plain, Pictures.pixels(scaled.scene()), tally);
    }
  }

  private static double[] clear(double scale, boolean mirrored, boolean parallel, Quaternion turn) {
    return Pictures.pixels(new ClearWorld(scale, mirrored, parallel, turn).scene());
  }

  private static void clearPowers(Tally tally) {
    for (boolean parallel : new boolean[] {false, true}) {
      double[] plain = clear(1, false, parallel, ClearWorld.TURN);
      for (int k : new int[] {-40, -11, -1, 1, 2, 30, 40}) {
        compare(plain, clear(Math.scalb(1.0, k), false, parallel, ClearWorld.TURN), tally);
      }
    }
  }

  private static void turned(Tally tally) {
    Quaternion q = ClearWorld.TURN;
    Quaternion opposite = new Quaternion(-q.w(), -q.x(), -q.y(), -q.z());
    compare(clear(1, false, false, q), clear(1, false, false, opposite), tally);
  }

  private static void mirrored(Tally tally) {
    for (boolean parallel : new boolean[] {false, true}) {
      double[] here = clear(1, false, parallel, ClearWorld.TURN);
      double[] there = clear(1, true, parallel, ClearWorld.TURN);
      compare(here, CameraCases.turned(there, ClearWorld.WIDTH), tally);
    }
  }

  private static void permuted(Tally tally) {
    permute(SampleWorld.PLAIN.scene().build(), tally);
    permute(ClearWorld.plain(false).scene().build(), tally);
    permute(ClearWorld.plain(true).scene().build(), tally);
  }

  private static void permute(Scene scene, Tally tally) {
    double[] plain = Pictures.render(scene, Set.of()).image().rgb();
    List<Placement> placements = new ArrayList<>(scene.placements());
    for (int i = 0; i < placements.size(); i++) {
      Collections.rotate(placements, i);
      Collections.swap(placements, 0, i);
      Scene.Builder other =
          new Scene.Builder("permuted")
              .size(scene.width(), scene.height())
              .camera(scene.camera())
              .background(scene.background());
      scene.lights().forEach(other::light);
      placements.forEach(other::place);
      compare(plain, Pictures.pixels(other), tally);
    }
  }

  private static final Set<Aov> FIRST_SEEN = Set.of(Aov.ID, Aov.DEPTH);

  private static RenderResult moved(int k) {
    double way = k < 0 ? 0 : Math.scalb(1.0, k);
    Vector3d offset = new Vector3d(way, -way / 2, way / 4);
    SampleWorld world = new SampleWorld(1, false, offset, SampleWorld.DULL);
    return Pictures.render(world.scene().build(), FIRST_SEEN);
  }

  private static void movedIds(Tally tally) {
    RenderResult here = moved(-1);
    for (int k : new int[] {4, 10, 20, 30, 40}) {
      RenderResult there = moved(k);
      for (Aov aov : FIRST_SEEN) {
        compare(here.aovs().get(aov).rgb(), there.aovs().get(aov).rgb(), tally);
      }
    }
  }

  /**
   * The bound of a pixel's change, in u·|move|/D with D the distance of the nearest light, 2.
   *
   * <p>A hit point, barycentric at worst, errs by 5u·|move| an axis and 9u·|move| in all, and the
   * way to a light, rounded again, by 2u·|move| more. Divided by D that turns the light's
   * direction, so that n·l ≤ 1 changes by 11, the inverse square by 22 and the highlight, to the
   * 40th power of an angle's cosine, by at most 20·11; the lights' strengths sum up to less than 2.
   */
  private static final double MOVED = 2 * (11 + 22 + 220);

  private static void movedRadiance(Tally tally) {
    double[] here = moved(-1).image().rgb();
    for (int k : new int[] {4, 10, 20, 30}) {
      double[] there = moved(k).image().rgb();
      for (int i = 0; i < here.length; i++) {
        tally.error(Math.abs(there[i] - here[i]) / (Rounding.U * Math.scalb(1.0, k) / 2));
        tally.check(true);
      }
    }
  }

  private static void split(Tally tally) {
    Vector3d corner = new Vector3d(-1, -1, 0.25);
    Vector3d p = new Vector3d(2, 0.25, -0.5);
    Vector3d q = new Vector3d(0.125, 2, 0.75);
    double[] whole = Pictures.pixels(lit().place(Placement.of(new Quad(corner, p, q), gloss())));
    Scene.Builder quarters = lit();
    for (int i = 0; i < 4; i++) {
      Vector3d at = corner.plus(p.times(0.5 * (i & 1))).plus(q.times(0.5 * (i >> 1)));
      quarters.place(Placement.of(new Quad(at, p.times(0.5), q.times(0.5)), gloss()));
    }
    double[] parts = Pictures.pixels(quarters);
    for (int i = 0; i < whole.length; i++) {
      tally.check(whole[i] > 0 == parts[i] > 0);
      tally.error(Math.abs(whole[i] - parts[i]));
    }
  }

  private static Material gloss() {
    return SampleWorld.GLOSSY;
  }

  private static Scene.Builder lit() {
    return Pictures.looking(new Vector3d(0.3, 0.4, 4), Vector3d.ZERO, 40)
        .light(new Light.Ambient(Rgb.grey(0.1)))
        .light(new Light.Point(new Vector3d(1, 2, 3), Rgb.grey(0.8), false));
  }
}

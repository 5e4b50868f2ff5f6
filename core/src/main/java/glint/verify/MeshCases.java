package glint.verify;

import glint.math.Vector3d;
import java.util.List;

/** Closed meshes seen from inside: a ray that hits nothing has slipped through. */
final class MeshCases {

  private MeshCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.exact("T02", "1520 triangles, from inside at corners", MeshCases::corners),
        HardCase.exact("T03", "1520 triangles, from inside at edges", MeshCases::edges),
        HardCase.exact("T17", "a cube of 12 triangles from inside", MeshCases::cube),
        HardCase.exact(
            "LEAK",
            "hills of 5120 (long: 20480) triangles, at corners and edges",
            MeshCases::hills),
        HardCase.exact(
            "LEAK-edge-on", "the same from eyes in the plane of a triangle", MeshCases::edgeOn));
  }

  private static void corners(Tally tally) {
    ClosedMesh globe = ClosedMesh.globe(2, 20, 40);
    Dice dice = new Dice(2);
    Shoot shoot = Shoot.throughTree(globe.primitives());
    for (int i = 0; i < 40_000; i++) {
      tally.check(shoot.through(dice.ball(1.9), globe.corners().get(i % globe.corners().size())));
    }
  }

  private static void edges(Tally tally) {
    ClosedMesh globe = ClosedMesh.globe(2, 20, 40);
    Dice dice = new Dice(3);
    Shoot shoot = Shoot.throughTree(globe.primitives());
    for (int i = 0; i < 40_000; i++) {
      tally.check(shoot.through(dice.ball(1.9), onEdge(dice, globe, i % globe.faces().size())));
    }
  }

  private static Vector3d onEdge(Dice dice, ClosedMesh mesh, int face) {
    int i = dice.below(3);
    Vector3d a = mesh.corner(face, i);
    return a.plus(mesh.corner(face, i + 1).minus(a).times(dice.in(0, 1)));
  }

  private static void cube(Tally tally) {
    Dice dice = new Dice(17);
    for (Vector3d place : new Vector3d[] {Vector3d.ZERO, new Vector3d(1e6, -3e5, 0.1)}) {
      ClosedMesh cube = ClosedMesh.cube(1).placed(1, place);
      Shoot scan = Shoot.scanning(cube.primitives());
      Shoot tree = Shoot.throughTree(cube.primitives());
      for (int i = 0; i < tally.times(100_000, 1_000_000); i++) {
        tally.check(tree.from(place.plus(dice.cube(0.999)), dice.unit()));
      }
      for (int i = 0; i < 1000; i++) {
        Vector3d o = i == 0 ? place : place.plus(dice.cube(0.999));
        for (int a = 0; a < 8; a++) {
          for (int b = 0; b <= a; b++) {
            // A corner with itself is a corner; the middle of two others, of an edge or a face.
            Vector3d p = cube.corners().get(a).plus(cube.corners().get(b)).times(0.5);
            boolean inside = (a ^ b) == 7;
            tally.check(inside || (scan.through(o, p) && tree.through(o, p)));
          }
        }
      }
    }
  }

  /** A mesh at a place, with eyes deep inside. */
  private record Scaled(ClosedMesh mesh, double scale, Vector3d middle) {

    static Scaled of(int splits, int which) {
      double scale = new double[] {1, 1, 0x1p-30, 1e6}[which];
      double away = new double[] {0, 1e6, 0, 1e9}[which];
      Vector3d middle = new Vector3d(0.6, -0.8, 0.3).times(away);
      return new Scaled(ClosedMesh.hills(splits).placed(scale, middle), scale, middle);
    }

    Vector3d eye(Dice dice) {
      return middle.plus(dice.ball(0.5 * scale));
    }

    boolean isDeep(Vector3d eye) {
      return eye.minus(middle).length() < 0.5 * scale;
    }
  }

  private static void hills(Tally tally) {
    Dice dice = new Dice(20);
    for (int which = 0; which < 4; which++) {
      Scaled hills = Scaled.of(tally.times(4, 5), which);
      Shoot shoot = Shoot.throughTree(hills.mesh.primitives());
      for (int i = 0; i < tally.times(50_000, 2_500_000); i++) {
        int face = dice.below(hills.mesh.faces().size());
        boolean atCorner = i % 2 == 0;
        Vector3d to = atCorner ? hills.mesh.corner(face, i) : onEdge(dice, hills.mesh, face);
        tally.check(shoot.through(hills.eye(dice), to));
      }
    }
  }

  /** The triangle aimed at is all but invisible: its neighbours have to close the gap. */
  private static void edgeOn(Tally tally) {
    Dice dice = new Dice(21);
    for (int which = 0; which < 4; which++) {
      Scaled hills = Scaled.of(tally.times(4, 5), which);
      Shoot shoot = Shoot.throughTree(hills.mesh.primitives());
      int wanted = tally.times(20_000, 1_000_000);
      while (wanted > 0) {
        int face = dice.below(hills.mesh.faces().size());
        Vector3d a = hills.mesh.corner(face, 0);
        Vector3d p = hills.mesh.corner(face, 1).minus(a);
        Vector3d n = p.cross(hills.mesh.corner(face, 2).minus(a)).normalized();
        Vector3d eye = hills.eye(dice);
        eye = eye.minus(n.times(eye.minus(a).dot(n)));
        if (hills.isDeep(eye)) {
          wanted--;
          boolean atCorner = wanted % 2 == 0;
          Vector3d to = atCorner ? hills.mesh.corner(face, wanted) : onEdge(dice, hills.mesh, face);
          tally.check(shoot.through(eye, to));
        }
      }
    }
  }
}

package glint.models;

import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.models.shape.Shape;
import glint.models.shape.Solid;
import glint.models.shape.Superellipsoid;
import glint.models.shape.SurfaceNets;
import java.util.ArrayList;
import java.util.List;

/**
 * A skull, solid as those that are cut from rock crystal.
 *
 * <p>Its height is 2.2, y is up, it looks along z; the origin lies between the ears.
 */
final class Skull {

  private static final double CELL = 0.063;
  private static final int TEETH_A_SIDE = 6;

  private Skull() {}

  static Model model() {
    Shape bone =
        SurfaceNets.of(bone(), new Vector3d(-0.9, -1.3, -1.3), new Vector3d(0.9, 1.4, 1.2), CELL);
    return Model.of(bone.plus(teeth(-0.55, 0.1, 1)).plus(teeth(-0.735, 0.09, 0.95)));
  }

  private static Solid bone() {
    return braincase().with(face(), 0.16).without(hollows(), 0.1).with(jaw(), 0.07).mirrored();
  }

  private static Solid braincase() {
    Solid back = Solid.ellipsoid(at(0, 0.55, -0.2), at(0.7, 0.66, 0.9));
    Solid forehead = Solid.ellipsoid(at(0, 0.56, 0.25), at(0.57, 0.56, 0.55));
    Solid base = Solid.ellipsoid(at(0, -0.02, -0.3), at(0.45, 0.3, 0.5));
    return back.with(forehead, 0.2).with(base, 0.25);
  }

  private static Solid face() {
    Solid brow = Solid.capsule(at(0.1, 0.3, 0.77), at(0.45, 0.3, 0.6), 0.1, 0.09);
    Solid rim = Solid.capsule(at(0.45, 0.3, 0.6), at(0.53, 0.02, 0.5), 0.08, 0.08);
    Solid cheek = Solid.capsule(at(0.38, -0.14, 0.65), at(0.6, -0.1, 0.4), 0.11, 0.09);
    Solid arch = Solid.capsule(at(0.6, -0.1, 0.4), at(0.66, 0.02, -0.1), 0.08, 0.06);
    Solid nose = Solid.capsule(at(0, 0.22, 0.76), at(0, 0.04, 0.9), 0.08, 0.05);
    Solid upperJaw = Solid.ellipsoid(at(0, -0.32, 0.46), at(0.34, 0.36, 0.4));
    Solid inner = Solid.ellipsoid(at(0, 0, 0.3), at(0.45, 0.45, 0.45));
    return brow.with(rim, 0.08)
        .with(cheek, 0.12)
        .with(arch, 0.06)
        .with(nose, 0.1)
        .with(upperJaw, 0.14)
        .with(inner, 0.1);
  }

  private static Solid hollows() {
    Solid eye = Solid.ellipsoid(at(0.29, 0.09, 0.8), at(0.2, 0.175, 0.36));
    Solid nose = Solid.ellipsoid(at(0.075, -0.15, 0.85), at(0.085, 0.13, 0.25));
    Solid noseTop = Solid.ellipsoid(at(0, -0.02, 0.88), at(0.06, 0.13, 0.2));
    Solid temple = Solid.ellipsoid(at(0.78, 0.16, 0.36), at(0.17, 0.3, 0.26));
    Solid underArch = Solid.ellipsoid(at(0.6, -0.3, 0.35), at(0.14, 0.16, 0.3));
    return eye.with(nose.with(noseTop, 0.05), 0).with(temple, 0).with(underArch, 0);
  }

  private static Solid jaw() {
    Solid chin = Solid.capsule(at(0, -0.98, 0.76), at(0.16, -0.98, 0.7), 0.12, 0.11);
    Solid body = Solid.capsule(at(0.16, -0.97, 0.69), at(0.5, -0.78, 0.05), 0.11, 0.11);
    Solid ramus =
        Solid.ellipsoid(at(0, 0, 0), at(0.08, 0.45, 0.2))
            .moved(Transform.rotate(Quaternion.aboutAxis(at(1, 0, 0), 12)))
            .moved(Transform.translate(at(0.53, -0.45, -0.04)));
    Solid gum = Solid.capsule(at(0, -0.86, 0.74), at(0.27, -0.84, 0.5), 0.1, 0.09);
    Solid inner = Solid.ellipsoid(at(0, -0.65, 0.28), at(0.36, 0.3, 0.42));
    return chin.with(body, 0.08).with(ramus, 0.1).with(gum, 0.1).with(inner, 0.1);
  }

  /** Returns a row of teeth along half an ellipse, the front ones the widest. */
  private static Shape teeth(double y, double height, double size) {
    List<Shape> teeth = new ArrayList<>();
    for (int i = 0; i < TEETH_A_SIDE; i++) {
      double angle = (i + 0.5) * 15.5;
      double radians = StrictMath.toRadians(angle);
      Shape tooth = Superellipsoid.of(at(0.055, height, 0.07), 0.5, 10, 8);
      teeth.add(
          tooth
              .moved(Transform.rotate(Quaternion.aboutAxis(at(0, 1, 0), angle)))
              .moved(
                  0.36 * size * StrictMath.sin(radians),
                  y,
                  0.36 + 0.44 * size * StrictMath.cos(radians)));
    }
    return Shape.of(teeth).withMirrorImage();
  }

  private static Vector3d at(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }
}

package glint.trace;

import glint.accel.Pencil;
import glint.geometry.Ray;
import glint.scene.Prepared;

/** One ray on its way, and what it carries; scratch, one for every level of the recursion. */
final class Frame {

  /** The ray, of unit direction. */
  final Ray ray = new Ray();

  /** Which pencil it is of, or null. */
  Pencil pencil;

  /** The media it is inside of. */
  final Interior interior;

  /** The parameter up to which absorption is counted already. */
  double from;

  /** The parameter at which it ends. */
  double end;

  /** The share of its radiance that reaches the eye. */
  double weightR;

  double weightG;
  double weightB;

  /**
   * By how much surfaces on the way have passed on more than they got: it is not worth more rays.
   */
  double gain;

  /** A number of its own in the tree of rays, from which it draws what is left to chance. */
  long path;

  Frame(Prepared scene) {
    interior = new Interior(scene);
  }

  /** Sets this to begin anew at its ray's origin. */
  void begin(double newEnd, double r, double g, double b) {
    pencil = null;
    from = 0;
    end = newEnd;
    weightR = r;
    weightG = g;
    weightB = b;
  }
}

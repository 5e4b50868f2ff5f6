package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;
import java.util.List;

/** A pyramid: an apex over a base of four corners, given in order around the base. */
public record Pyramid(Vector3d apex, List<Vector3d> base) implements Surface {

  /** Checks that there are four base corners and that all five are finite. */
  public Pyramid {
    base = List.copyOf(base);
    Check.finite("apex", apex);
    if (base.size() != 4) {
      throw new BadValueException("base", "must have 4 corners, but has " + base.size());
    }
    for (Vector3d corner : base) {
      Check.finite("base", corner);
    }
  }
}

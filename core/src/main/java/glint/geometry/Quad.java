package glint.geometry;

import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/** A parallelogram: {@code corner} and the two edges that leave it; visible from both sides. */
public record Quad(Vector3d corner, Vector3d edge1, Vector3d edge2) implements Surface {

  /** Checks that all three are finite and the edges span an area. */
  public Quad {
    Check.finite("corner", corner);
    Check.direction("edge1", edge1);
    Check.direction("edge2", edge2);
    if (edge1.normalized().cross(edge2.normalized()).maxAbs() == 0) {
      throw new BadValueException("edge2", "must not be parallel to edge1");
    }
  }
}

package glint.verify;

import glint.math.Vector3d;
import java.util.List;

/** What is true of a surface and a line, computed without rounding. */
interface Oracle {

  /** Returns where the line {@code o + t d} crosses the surface, or barely fails to. */
  List<Crossing> crossings(Vector3d o, Vector3d d);
}

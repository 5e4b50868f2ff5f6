package glint.accel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.geometry.Box;
import glint.geometry.Plane;
import glint.geometry.Primitives;
import glint.geometry.Sphere;
import glint.math.Transform;
import glint.math.Vector3d;
import org.junit.jupiter.api.Test;

/** Boxes of a handful of primitives. */
class BoxesTest {

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  @Test
  void smallBoxesAreTriedFirst() {
    Primitives.Builder builder = new Primitives.Builder();
    builder.add(new Box(v(-8, -1, -8), v(8, 0, 8)), Transform.IDENTITY, 0);
    builder.add(new Plane(v(0, -1, 0), v(0, 1, 0)), Transform.IDENTITY, 1);
    builder.add(new Sphere(v(0, 1, 0), 1), Transform.IDENTITY, 2);
    builder.add(new Box(v(2, 0, 2), v(5, 3, 5)), Transform.IDENTITY, 3);
    Primitives primitives = builder.build();
    Boxes boxes = Boxes.around(primitives);
    int[] surfaces = new int[3];
    for (int i = 0; i < 3; i++) {
      surfaces[i] = primitives.surface(boxes.slots[i]);
    }
    assertArrayEquals(new int[] {2, 3, 0}, surfaces);
    assertEquals(-1, Float.intBitsToFloat(boxes.bits[0]), 1e-6);
    assertEquals(8, Float.intBitsToFloat(boxes.bits[15]), 1e-5);
  }
}

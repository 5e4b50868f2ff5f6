package glint.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class MeshEdgesTest {

  private static final double[] TETRAHEDRON = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  private static final int[] FACES = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

  private static int[] changed(int at, int... corners) {
    int[] faces = FACES.clone();
    System.arraycopy(corners, 0, faces, at, corners.length);
    return faces;
  }

  @Test
  void aBodyIsClosedAndOneWithAHoleIsNot() {
    assertTrue(new Mesh(TETRAHEDRON, FACES).isClosed());
    for (int face = 0; face < 4; face++) {
      int[] corners = FACES.clone();
      int[] three = new int[9];
      System.arraycopy(corners, 0, three, 0, 3 * face);
      System.arraycopy(corners, 3 * face + 3, three, 3 * face, 9 - 3 * face);
      assertFalse(new Mesh(TETRAHEDRON, three).isClosed());
    }
    assertFalse(new Mesh(TETRAHEDRON, new int[0]).isClosed());
  }

  @Test
  void aFaceThatLooksInwardsOpensIt() {
    assertFalse(new Mesh(TETRAHEDRON, changed(3, 0, 3, 1)).isClosed());
    // All of them do: a hollow in something endless is closed as well.
    int[] inward = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
    assertTrue(new Mesh(TETRAHEDRON, inward).isClosed());
  }

  @Test
  void aFaceTwiceOrWithoutAreaDecidesNothingByItself() {
    int[] more = Arrays.copyOf(FACES, 15);
    System.arraycopy(FACES, 0, more, 12, 3);
    assertFalse(new Mesh(TETRAHEDRON, more).isClosed(), "a face twice");
    System.arraycopy(new int[] {1, 1, 3}, 0, more, 12, 3);
    assertTrue(new Mesh(TETRAHEDRON, more).isClosed(), "an edge there and back");
    System.arraycopy(new int[] {2, 2, 2}, 0, more, 12, 3);
    assertTrue(new Mesh(TETRAHEDRON, more).isClosed(), "a point");
  }

  @Test
  void cornersAreOneByTheirPlaceNotTheirNumber() {
    double[] apart = new double[36];
    int[] corners = new int[12];
    for (int i = 0; i < 12; i++) {
      corners[i] = i;
      System.arraycopy(TETRAHEDRON, 3 * FACES[i], apart, 3 * i, 3);
    }
    apart[0] = -0.0;
    assertEquals(12, apart.length / 3);
    assertTrue(new Mesh(apart, corners).isClosed());
    apart[3] += Math.ulp(1.0);
    assertFalse(new Mesh(apart, corners).isClosed());
  }
}

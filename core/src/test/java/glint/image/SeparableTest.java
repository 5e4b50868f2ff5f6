package glint.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class SeparableTest {

  @Test
  void repeatsTheBorder() {
    double[] plane = {1, 2, 4, 8, 16, 32};
    double[] left = {1, 0, 0};
    double[] none = {1};
    assertArrayEquals(new double[] {1, 1, 2, 8, 8, 16}, Separable.filter(plane, 3, 2, left, none));
    assertArrayEquals(new double[] {1, 2, 4, 1, 2, 4}, Separable.filter(plane, 3, 2, none, left));
    double[] farRight = {0, 0, 0, 0, 0, 0, 1};
    assertArrayEquals(
        new double[] {4, 4, 4, 32, 32, 32}, Separable.filter(plane, 3, 2, farRight, none));
  }

  @Test
  void weighsByTheProductOfBothKernels() {
    double[] dot = new double[25];
    dot[12] = 1;
    double[] filtered =
        Separable.filter(dot, 5, 5, new double[] {2, 3, 5}, new double[] {7, 11, 13});
    // A correlation: the pixel left of the dot sees it on its right
    assertEquals(5 * 11, filtered[11]);
    assertEquals(2 * 11, filtered[13]);
    assertEquals(3 * 13, filtered[7]);
    assertEquals(2 * 7, filtered[18]);
  }

  @Test
  void gaussianSumsToOne() {
    double[] kernel = Separable.gaussian(5, 1 / 4.5);
    assertEquals(11, kernel.length);
    assertEquals(1, Arrays.stream(kernel).sum(), 1e-15);
    assertEquals(Math.exp(-4 / 4.5), kernel[7] / kernel[5], 1e-15);
  }
}

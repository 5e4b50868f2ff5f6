package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Hit;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class SignatureTest {

  /** The first surface in the light of the first light, and out of it: both have the number 0. */
  @Test
  void thingsWithTheNumberZeroAreMet() {
    Set<Long> values = new HashSet<>();
    Signature signature = new Signature();
    for (int i = 0; i < 1000; i++) {
      assertTrue(values.add(signature.value()), "different after " + i + " zeros");
      signature.add(0);
    }
  }

  @Property
  void listsOfThingsDifferIfAndOnlyIfTheirSignaturesDo(
      @ForAll @Size(max = 6) List<@IntRange(min = -3, max = 3) Integer> one,
      @ForAll @Size(max = 6) List<@IntRange(min = -3, max = 3) Integer> two) {
    assertEquals(one.equals(two), signature(one) == signature(two));
  }

  /** Ends of axes, and what lies one facet beside them, in every order and of either sign. */
  @Test
  void flatFacesDifferByTheirNormals() {
    double[] components = {-1, -1 + 0x1p-10, -0x1p-10, 0, 0x1p-10, 1 - 0x1p-10, 1};
    Set<Long> values = new HashSet<>();
    for (double x : components) {
      for (double y : components) {
        for (double z : components) {
          assertTrue(values.add(ofFace(x, y, z)), "different: " + x + " " + y + " " + z);
          double less = 0x1p-12;
          assertEquals(ofFace(x, y, z), ofFace(x + less, y - less, z + less), "the same face");
        }
      }
    }
  }

  private static long ofFace(double nx, double ny, double nz) {
    Hit hit = new Hit();
    hit.nx = nx;
    hit.ny = ny;
    hit.nz = nz;
    hit.sx = nx;
    hit.sy = ny;
    hit.sz = nz;
    Signature signature = new Signature();
    signature.add(hit, 0);
    return signature.value();
  }

  private static long signature(List<Integer> things) {
    Signature signature = new Signature();
    signature.clear();
    things.forEach(signature::add);
    return signature.value();
  }
}

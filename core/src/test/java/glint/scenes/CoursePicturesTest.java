package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import glint.color.Transfer;
import glint.image.Image;
import glint.scene.Scene;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes of the course that the CS 315 format comes from, against the course's own pictures. */
class CoursePicturesTest {

  /** The course's scenes and pictures are not ours to pass on; they lie beside the repository. */
  private static final Path FOLDER = Repository.root().resolve("../shared/data/cs148").normalize();

  /** One pixel in so many may differ: shared edges and grazing mirror rays are ties. */
  private static final int ONE_IN = 2000;

  @ParameterizedTest
  @ValueSource(
      strings = {"CornellBox", "ShadowTest1", "SphereShadingTest1", "SphereTest", "TriangleTest"})
  void equalsTheCoursesPicture(String name) throws IOException {
    Path text = FOLDER.resolve(name + ".txt");
    assumeTrue(Files.exists(text), () -> "skipped: the course's scenes are not there: " + text);
    Scene scene = Repository.read(text).scenes().get(0);
    assertEquals(Transfer.LINEAR, scene.transfer());
    BufferedImage expected = ImageIO.read(FOLDER.resolve(name + ".png").toFile());
    assertEquals(expected.getWidth(), scene.width());
    assertEquals(expected.getHeight(), scene.height());

    Image actual = Repository.render(scene, scene.width(), scene.height()).image();
    int different = 0;
    for (int y = 0; y < actual.height(); y++) {
      for (int x = 0; x < actual.width(); x++) {
        different += difference(expected.getRGB(x, y), actual, x, y) > 1 ? 1 : 0;
      }
    }
    int count = different;
    assertTrue(
        count * ONE_IN <= actual.width() * actual.height(),
        () -> name + ": " + count + " pixels differ by more than one code");
  }

  /** Returns by how many codes the worst channel differs. */
  private static int difference(int expected, Image actual, int x, int y) {
    double[] rgb = actual.rgb();
    int worst = 0;
    for (int channel = 0; channel < 3; channel++) {
      int code = Transfer.LINEAR.code(rgb[3 * (y * actual.width() + x) + channel]);
      worst = Math.max(worst, Math.abs(code - (expected >> 16 - 8 * channel & 255)));
    }
    return worst;
  }
}

package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import glint.color.Rgb;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.render.Replay;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.RayCounts;
import glint.trace.RayTree;
import glint.trace.RayTree.Fate;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The trees of all pixels add up to the image, bit for bit, and hold every ray of the render. */
class ReplayedScenesTest {

  private static final int WIDTH = 20;
  private static final int HEIGHT = 15;
  private static final int SAMPLES = 3;

  static Stream<Path> sceneFiles() {
    return Repository.sceneFiles().stream();
  }

  @ParameterizedTest
  @MethodSource("sceneFiles")
  void treesAddUpToTheImage(Path file) {
    for (Scene scene : Repository.read(file).scenes()) {
      check(Prepared.of(scene));
    }
  }

  private static void check(Prepared scene) {
    RenderSettings settings =
        new RenderSettings(WIDTH, HEIGHT, SAMPLES, 7, OptionalInt.empty(), 1, 32, Set.of());
    RenderResult result = new Renderer(scene, settings).render(Progress.NONE);
    double[] image = result.image().rgb();
    RayCounts counts = new RayCounts();
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        Replay replay = new Replay(scene, settings, x, y);
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < SAMPLES; i++) {
          RayTree tree = replay.sample(i).tree();
          sum = sum.plus(tree.radiance());
          count(tree, scene, counts);
        }
        int at = 3 * (y * WIDTH + x);
        Rgb stored = new Rgb(image[at], image[at + 1], image[at + 2]);
        String name = scene.scene().name() + " at " + x + "," + y;
        assertEquals(stored, replay.value(), name);
        assertEquals(
            stored, new Rgb(sum.r() / SAMPLES, sum.g() / SAMPLES, sum.b() / SAMPLES), name);
      }
    }
    RayCounts rays = result.statistics().rays();
    assertEquals(rays.camera, counts.camera);
    assertEquals(rays.reflection, counts.reflection);
    assertEquals(rays.refraction, counts.refraction);
    assertEquals(rays.shadow, counts.shadow);
    assertEquals(rays.maxDepth, counts.maxDepth);
  }

  private static void count(RayTree tree, Prepared scene, RayCounts counts) {
    for (RayTree ray : tree.rays()) {
      switch (ray.kind()) {
        case CAMERA -> counts.camera++;
        case REFLECTION -> counts.reflection++;
        case REFRACTION, STRAIGHT -> counts.refraction++;
      }
      counts.maxDepth = Math.max(counts.maxDepth, ray.bounces());
      for (RayTree.Lighting light : ray.sight().lights()) {
        boolean asked = light.fate() == Fate.LIT || light.fate() == Fate.SHADOWED;
        counts.shadow += asked && scene.plan().shadows().used() ? 1 : 0;
      }
    }
  }
}

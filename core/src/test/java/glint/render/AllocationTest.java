package glint.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import glint.image.Image;
import glint.scene.Prepared;
import java.lang.management.ManagementFactory;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Tracing makes no garbage: everything mutable is scratch that a worker owns. */
class AllocationTest {

  @Test
  void aSecondRenderAllocatesLessThanAByteARay() {
    Prepared scene = Prepared.of(new RendererTest.World(1, false).scene().build());
    RenderSettings settings =
        new RenderSettings(97, 61, 8, 0, OptionalInt.empty(), 1, 32, Set.of());
    Image image = new Image(settings.width(), settings.height());
    Worker worker =
        new Worker(
            scene,
            settings,
            image,
            new double[settings.width() * settings.height()],
            new Settling(settings.samples(), image, scene.scene().transfer(), true),
            new Looker(scene, Map.of()),
            () -> false);
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    render(worker);
    long raysBefore = worker.probe().counts().total();
    long bytesBefore = threads.getCurrentThreadAllocatedBytes();
    render(worker);
    long bytes = threads.getCurrentThreadAllocatedBytes() - bytesBefore;
    long rays = worker.probe().counts().total() - raysBefore;
    assertTrue(bytes < rays, bytes + " bytes for " + rays + " rays");
  }

  private static void render(Worker worker) {
    for (int y = 0; y < 61; y++) {
      for (int x = 0; x < 97; x++) {
        worker.pixel(x, y);
      }
    }
  }
}

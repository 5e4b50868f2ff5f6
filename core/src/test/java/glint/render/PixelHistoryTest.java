package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.scene.Prepared;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

class PixelHistoryTest {

  private static final Prepared SCENE =
      Prepared.of(new RendererTest.World(1, false).scene().build());

  private static final RenderSettings SETTINGS =
      new RenderSettings(
          24, 16, new Goal.Error(2), 3, OptionalInt.of(3), 2, 8, Set.of(Aov.ERROR, Aov.SAMPLES));

  @Test
  void aPixelHasTheValueAndTheRaysOfItsImage() {
    RenderResult result = new Renderer(SCENE, SETTINGS).render(Progress.NONE);
    int most = 0;
    for (int pixel = 0; pixel < 24 * 16; pixel += 37) {
      PixelHistory history = PixelHistory.of(SCENE, SETTINGS, pixel % 24, pixel / 24);
      double[] rgb = result.image().rgb();
      Rgb value = new Rgb(rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]);
      assertEquals(value, history.value());
      assertEquals(result.aovs().get(Aov.ERROR).rgb()[3 * pixel], history.error());
      List<Replay.Sample> rays = history.rays();
      // Of its corners and searches a pixel counts only those above and to the left.
      assertTrue(rays.size() >= Math.max(1, result.aovs().get(Aov.SAMPLES).rgb()[3 * pixel]));
      assertEquals(0, rays.get(0).x() % 1);
      assertEquals(0, rays.get(0).y() % 1);
      most = Math.max(most, rays.size());
      if (rays.size() == 4 && rays.stream().allMatch(each -> each.x() % 1 == 0)) {
        double corners = rays.stream().mapToDouble(each -> each.tree().radiance().r()).sum();
        assertEquals(value.r(), corners / 4, 1e-15);
      }
    }
    assertTrue(most > 8, "some pixel was sampled");
  }

  @Test
  void aPixelIsInTheImage() {
    assertThrows(BadValueException.class, () -> PixelHistory.of(SCENE, SETTINGS, 24, 0));
  }
}

package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.image.Image;
import glint.scene.Prepared;
import java.util.Arrays;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What an image of as many samples for every pixel claims of its error. */
class SettlingTest {

  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;

  private static final Prepared SCENE =
      Prepared.of(new RendererTest.World(1, false).scene().build());

  private static RenderResult render(int samples, long seed, int tile, Set<Aov> aovs) {
    RenderSettings settings =
        new RenderSettings(WIDTH, HEIGHT, samples, seed, OptionalInt.of(8), 2, tile, aovs);
    return new Renderer(SCENE, settings).render(Progress.NONE);
  }

  private static double error(Image image, Image truth) {
    Transfer transfer = SCENE.scene().transfer();
    double sum = 0;
    for (int i = 0; i < truth.rgb().length; i++) {
      double delta = transfer.level(image.rgb()[i]) - transfer.level(truth.rgb()[i]);
      sum += delta * delta;
    }
    return Math.sqrt(sum / truth.rgb().length);
  }

  @Test
  void aClaimIsAboutTheTruth() {
    Image truth = render(256, -1, 32, Set.of()).image();
    for (int samples : new int[] {1, 2, 3, 4, 6, 16}) {
      RenderResult result = render(samples, samples, 32, Set.of());
      double ratio = error(result.image(), truth) / result.statistics().samplingError();
      assertTrue(ratio > 0.6 && ratio < 1.1, () -> samples + ": true over claimed " + ratio);
    }
  }

  @Test
  void theClaimsOfPixelsMakeThatOfTheImageWhateverTheTiles() {
    RenderResult result = render(16, 0, 7, Set.of(Aov.ERROR, Aov.SAMPLES));
    RenderResult other = render(16, 0, 32, Set.of());
    double claimed = result.statistics().samplingError();
    assertEquals(other.statistics().samplingError(), claimed);
    double sum = 0;
    for (double value : result.aovs().get(Aov.ERROR).rgb()) {
      sum += value * value / (3 * WIDTH * HEIGHT);
    }
    assertEquals(claimed, Math.sqrt(sum), 0.15 * claimed);
    assertEquals(16, result.aovs().get(Aov.SAMPLES).rgb()[0]);
  }

  @Test
  void whatIsTheSameEverywhereHasNoError() {
    Image image = new Image(3, 2);
    Arrays.fill(image.rgb(), 0.5);
    Settling settling = new Settling(1, image, Transfer.SRGB, true);
    settling.conclude();
    assertEquals(0, settling.error());
    image.set(1, 0, 1, 1, 1);
    Settling bent = new Settling(1, image, Transfer.LINEAR, true);
    bent.conclude();
    // One row bends by two steps of 127.5 levels, in the middle one of six pixels.
    double variance = 4 * 127.5 * 127.5 / 24;
    double mean = variance * (1 + 1.65) / 6;
    assertEquals(1.2 * Math.sqrt(mean), bent.error(), 0.02);
    assertEquals(1.2 * Math.sqrt(variance / 4), bent.error(2, 1), 0.02);
  }
}

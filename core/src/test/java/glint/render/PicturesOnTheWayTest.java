package glint.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.scene.Prepared;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** What a render to an error shows before it is done, and how it is held. */
class PicturesOnTheWayTest {

  private static final Scene SCENE = new RendererTest.World(1, false).scene().build();

  /** Sizes of neither whole blocks nor whole tiles, and of both. */
  @Test
  void theFirstPictureHasOneColourABlockAndTheCornersOfTheFinalRaysInIt() {
    for (int[] size : new int[][] {{45, 29}, {48, 32}, {1, 1}}) {
      Renderer renderer = renderer(size[0], size[1]);
      List<double[]> pictures = new ArrayList<>();
      List<Double> errors = new ArrayList<>();
      List<Long> rays = new ArrayList<>();
      RenderResult result =
          renderer.render(
              new Heard() {
                @Override
                public void pictureImproved(double error, long traced) {
                  pictures.add(renderer.image().rgb().clone());
                  errors.add(error);
                  rays.add(traced);
                }
              });
      double[] first = pictures.get(0);
      for (int i = 0; i < first.length; i++) {
        int x = i / 3 % size[0] / 8 * 8;
        int y = i / 3 / size[0] / 8 * 8;
        assertEquals(first[3 * (y * size[0] + x) + i % 3], first[i]);
      }
      assertEquals(Double.POSITIVE_INFINITY, errors.get(0));
      assertEquals(result.statistics().samplingError(), errors.get(errors.size() - 1));
      int blocks = ((size[0] + 7) / 8) * ((size[1] + 7) / 8);
      assertTrue(rays.get(0) >= blocks && rays.get(0) < rays.get(1), rays.toString());
      assertTrue(rays.get(rays.size() - 1) <= result.statistics().rays().total());
    }
  }

  @Test
  void whatPixelsClaimAndTookIsThereWithEveryPicture() {
    RenderSettings plain = settings(45, 29);
    Set<Aov> aovs = Set.of(Aov.ERROR, Aov.SAMPLES);
    Renderer renderer =
        new Renderer(Prepared.of(SCENE), plain.aiming(plain.goal(), plain.seed(), aovs));
    List<double[]> errors = new ArrayList<>();
    List<double[]> samples = new ArrayList<>();
    RenderResult result =
        renderer.render(
            new Heard() {
              @Override
              public void pictureImproved(double error, long traced) {
                if (error < Double.POSITIVE_INFINITY) {
                  errors.add(renderer.aovs().get(Aov.ERROR).rgb().clone());
                  samples.add(renderer.aovs().get(Aov.SAMPLES).rgb().clone());
                  double squares =
                      Arrays.stream(errors.get(errors.size() - 1)).map(e -> e * e).sum();
                  double rms = Math.sqrt(squares / (3 * 45 * 29));
                  assertTrue(rms > error / 4 && rms <= error, rms + " of " + error);
                }
              }
            });
    int last = errors.size() - 1;
    assertTrue(last > 0);
    assertArrayEquals(result.aovs().get(Aov.ERROR).rgb(), errors.get(last));
    assertArrayEquals(result.aovs().get(Aov.SAMPLES).rgb(), samples.get(last));
    assertTrue(Arrays.stream(samples.get(0)).sum() < Arrays.stream(samples.get(last)).sum());
    RenderResult without = renderer(45, 29).render(Progress.NONE);
    assertEquals(without.image().sha256(), result.image().sha256());
    assertEquals(without.statistics().rays().total(), result.statistics().rays().total());
  }

  @Test
  void aRenderThatIsHeldDoesNothingUntilItIsLetGoAndGivesTheSameImage() throws Exception {
    Renderer renderer = renderer(96, 64);
    CountDownLatch held = new CountDownLatch(1);
    List<Long> heard = new ArrayList<>();
    FutureTask<RenderResult> render =
        new FutureTask<>(
            () ->
                renderer.render(
                    new Heard() {
                      @Override
                      public void pictureImproved(double error, long traced) {
                        if (held.getCount() > 0) {
                          renderer.pause();
                          held.countDown();
                        }
                      }

                      @Override
                      public void tileDone(int done, int total, long traced) {
                        synchronized (heard) {
                          heard.add(traced);
                        }
                      }
                    }));
    new Thread(render).start();
    assertTrue(held.await(30, TimeUnit.SECONDS));
    Thread.sleep(200);
    synchronized (heard) {
      assertEquals(List.of(), heard);
    }
    assertFalse(render.isDone());
    renderer.resume();
    String sha = render.get(30, TimeUnit.SECONDS).image().sha256();
    assertEquals(renderer(96, 64).render(Progress.NONE).image().sha256(), sha);
  }

  @Test
  void aRenderThatIsHeldCanBeCancelled() throws Exception {
    Renderer renderer = renderer(96, 64);
    renderer.pause();
    FutureTask<RenderResult> render = new FutureTask<>(() -> renderer.render(Progress.NONE));
    new Thread(render).start();
    Thread.sleep(50);
    assertFalse(render.isDone());
    renderer.cancel();
    Throwable failure = assertThrows(Exception.class, () -> render.get(30, TimeUnit.SECONDS));
    assertEquals(CancellationException.class, failure.getCause().getClass());
  }

  /** A render of samples begins every tile once; one to an error tells of single pixels, too. */
  @Test
  void everyPartOfTheImageIsToldOfWhenItIsBegun() {
    RenderSettings toError = settings(75, 41);
    RenderSettings mapped = toError.aiming(toError.goal(), 0, Set.of(Aov.ERROR));
    for (RenderSettings settings : List.of(toError, mapped, toError.sampled(2, 0))) {
      List<int[]> parts = Collections.synchronizedList(new ArrayList<>());
      List<Long> counts = new ArrayList<>();
      new Renderer(Prepared.of(SCENE), settings)
          .render(
              new Heard() {
                @Override
                public void traced(long rays) {
                  counts.add(rays);
                }

                @Override
                public void begun(int x, int y, int endX, int endY) {
                  parts.add(new int[] {x, y, endX, endY});
                }
              });
      int[] begun = new int[75 * 41];
      int narrow = 0;
      for (int[] part : parts) {
        assertTrue(part[0] >= 0 && part[0] < part[2] && part[2] <= 75);
        assertTrue(part[1] >= 0 && part[1] < part[3] && part[3] <= 41);
        narrow += part[3] - part[1] < 9 ? 1 : 0;
        for (int y = part[1]; y < part[3]; y++) {
          for (int x = part[0]; x < part[2]; x++) {
            begun[75 * y + x]++;
          }
        }
      }
      boolean uniform = settings.goal() instanceof Goal.Samples;
      for (int count : begun) {
        assertTrue(uniform ? count == 1 : count >= 2, "begun " + count + " times");
      }
      assertEquals(uniform, narrow == 0);
      assertEquals(uniform, counts.isEmpty());
      assertEquals(counts.stream().sorted().toList(), counts);
    }
  }

  private static RenderSettings settings(int width, int height) {
    Goal goal = new Goal.Error(1);
    return new RenderSettings(width, height, goal, 0, OptionalInt.empty(), 2, 16, Set.of());
  }

  private static Renderer renderer(int width, int height) {
    return new Renderer(Prepared.of(SCENE), settings(width, height));
  }

  /** Hears nothing of tiles. */
  private interface Heard extends Progress {
    @Override
    default void tileDone(int done, int total, long rays) {}
  }
}

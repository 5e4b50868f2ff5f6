package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.geometry.Quad;
import glint.math.BadValueException;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.sampling.SobolSampler;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** One pixel again. */
class ReplayTest {

  private static Scene.Builder scene() {
    return new Scene.Builder("edge")
        .camera(
            Camera.of(
                new Vector3d(0, 0, 1),
                Vector3d.ZERO,
                new Vector3d(0, 1, 0),
                Projection.vertical(50)));
  }

  private static RenderSettings settings(int samples) {
    return new RenderSettings(9, 7, samples, 0, OptionalInt.empty(), 1, 32, Set.of());
  }

  /** White on the left; a black half-plane begins in the middle of the middle column. */
  private static Prepared edge() {
    Quad black = new Quad(new Vector3d(0, -9, 0), new Vector3d(9, 0, 0), new Vector3d(0, 18, 0));
    return Prepared.of(
        scene()
            .background(Background.constant(Rgb.WHITE))
            .place(Placement.of(black, Material.WHITE))
            .build());
  }

  @Test
  void samplesLieWhereTheSequenceSays() {
    Replay replay = new Replay(edge(), settings(16), 4, 3);
    assertEquals(Rgb.grey(0.5), replay.value());
    assertEquals(0, replay.invalid());
    SobolSampler sampler = new SobolSampler(0);
    sampler.pixel(4, 3);
    for (int i = 0; i < 16; i++) {
      Replay.Sample sample = replay.sample(i);
      sampler.sample(i);
      assertEquals(i, sample.number());
      assertEquals(sampler.x, sample.x());
      assertEquals(sampler.y, sample.y());
      assertEquals(sample.x() < 0.5 ? Rgb.WHITE : Rgb.BLACK, sample.tree().radiance());
    }
    Replay.Sample centre = new Replay(edge(), settings(1), 4, 3).sample(0);
    assertEquals(0.5, centre.x());
    assertEquals(0.5, centre.y());
  }

  @Test
  void theFarthestSamplesComeFirst() {
    // With five samples of two values, those of the rarer one are farther from the mean.
    Replay replay = new Replay(edge(), settings(5), 4, 3);
    List<Integer> all = replay.farthest(9);
    assertEquals(List.of(0, 1, 2, 3, 4), all.stream().sorted().toList());
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 5; i++) {
      double distance =
          Math.abs(replay.sample(all.get(i)).tree().radiance().r() - replay.value().r());
      assertTrue(distance <= before);
      assertTrue(distance < before || all.get(i) > all.get(i - 1), "equals in their order");
      before = distance;
    }
    assertEquals(all.subList(0, 2), replay.farthest(2));
  }

  @Test
  void whatIsNotFiniteIsCountedAndFarthestOfAll() {
    Material blinding =
        new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.WHITE, Rgb.grey(Double.MAX_VALUE));
    Vector3d z = new Vector3d(0, 0, 1);
    Prepared mirrors =
        Prepared.of(
            scene()
                .place(Placement.of(new Plane(new Vector3d(0, 0, -1), z), blinding))
                .place(Placement.of(new Plane(new Vector3d(0, 0, 2), z), blinding))
                .build());
    Replay replay = new Replay(mirrors, settings(4), 4, 3);
    assertEquals(4, replay.invalid());
    assertEquals(Rgb.BLACK, replay.value());
    assertEquals(List.of(0, 1, 2, 3), replay.farthest(4));
  }

  @Test
  void aPixelOutsideIsRefused() {
    for (int[] pixel : new int[][] {{9, 0}, {0, 7}, {-1, 0}, {0, -1}}) {
      BadValueException e =
          assertThrows(
              BadValueException.class, () -> new Replay(edge(), settings(1), pixel[0], pixel[1]));
      assertEquals(
          "pixel " + pixel[0] + "," + pixel[1] + " is outside of the image, which has 9x7 pixels",
          e.getMessage());
    }
  }
}

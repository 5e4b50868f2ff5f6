package glint.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.geometry.Ray;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.sampling.SobolSampler;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Mirrors that spread what they show. */
class GlossTest {

  private static final int SAMPLES = 1 << 12;
  private static final int PARTS = 1000;

  private static Prepared floor(double gloss) {
    Material mirror =
        new Material(Rgb.BLACK, Rgb.BLACK, Rgb.BLACK, 1, Rgb.WHITE, Rgb.BLACK).glossy(gloss);
    Vector3d up = new Vector3d(0, 1, 0);
    return Prepared.of(
        new Scene.Builder("floor")
            .camera(Camera.of(new Vector3d(0, 1, 1), Vector3d.ZERO, up, Projection.vertical(40)))
            .background(new Background(Rgb.BLACK, Rgb.WHITE))
            .place(Placement.of(new Plane(Vector3d.ZERO, up), mirror))
            .build());
  }

  private static Ray at(double degrees) {
    double angle = StrictMath.toRadians(degrees);
    double sin = StrictMath.sin(angle);
    double cos = StrictMath.cos(angle);
    Ray ray = new Ray();
    ray.set(-sin, cos, 0, sin, -cos, 0);
    return ray;
  }

  private static double mean(Prepared scene, Ray ray) {
    Tracer tracer = new Tracer(scene, 1, 0);
    SobolSampler numbers = new SobolSampler(3);
    numbers.pixel(0, 0);
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
      numbers.sample(i);
      tracer.trace(ray, Double.POSITIVE_INFINITY, numbers);
      sum += tracer.r;
    }
    assertTrue(numbers.hasDrawn());
    return sum / SAMPLES;
  }

  /** The mean of (1 + |d_y|)/2 over the lobe: what leads down is mirrored. */
  private static double summed(double degrees, double n) {
    double angle = StrictMath.toRadians(degrees);
    double sum = 0;
    for (int i = 0; i < PARTS; i++) {
      double cos = StrictMath.pow((i + 0.5) / PARTS, 1 / (n + 1));
      double sin = Math.sqrt(1 - cos * cos);
      for (int j = 0; j < PARTS; j++) {
        double phi = Math.PI * (j + 0.5) / PARTS;
        double y = StrictMath.cos(angle) * cos + StrictMath.sin(angle) * sin * StrictMath.cos(phi);
        sum += (1 + Math.abs(y)) / 2;
      }
    }
    return sum / PARTS / PARTS;
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0, 20", "40, 1", "60, 5", "85, 0", "85, 30", "89, 400"})
  void theLobeIsWhatItIsSaidToBe(double degrees, double gloss) {
    assertEquals(summed(degrees, gloss), mean(floor(gloss), at(degrees)), 1e-4);
  }

  @Test
  void aHugeExponentIsNearlyAMirror() {
    Prepared mirror = floor(Double.POSITIVE_INFINITY);
    assertTrue(!mirror.plan().gloss().used());
    Tracer tracer = new Tracer(mirror, 1, 0);
    for (int degrees = 0; degrees < 90; degrees += 10) {
      tracer.trace(at(degrees), Double.POSITIVE_INFINITY);
      assertEquals(tracer.r, mean(floor(1e9), at(degrees)), 1e-6);
    }
  }

  /** A sample that leaves nothing to chance goes where a mirror sends it, bit for bit. */
  @Test
  void theMiddleOfTheLobeIsTheMirrorsRay() {
    Tracer mirror = new Tracer(floor(Double.POSITIVE_INFINITY), 1, 0);
    Tracer glossy = new Tracer(floor(3), 1, 0);
    for (int degrees = 0; degrees < 90; degrees++) {
      mirror.trace(at(degrees), Double.POSITIVE_INFINITY);
      glossy.trace(at(degrees), Double.POSITIVE_INFINITY);
      assertEquals(mirror.r, glossy.r);
    }
  }
}

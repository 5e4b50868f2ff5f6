package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import glint.color.Transfer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Scenes whose every pixel has one true value, through the command. */
class FurnaceTest {

  /** Rays pass the ball at up to 0.9989 of its radius, in the corners; the mirrors lose nothing. */
  private static final String SCENES =
      """
      defaults:
        image: {width: 20, height: 20}
        camera: {position: [0, 0, 5], look_at: [0, 0, 0], orthographic: 1.487}
      scenes:
        ball:
          background: 1
          surfaces:
            - sphere: {center: [0, 0, 0], radius: 1, material: {transparency: 1, ior: 1.5}}
        mirrors:
          surfaces:
            - plane: {point: [0, 0, 0], normal: [0, 0, 1], material: &m {reflection: 1, emission: 0.25}}
            - plane: {point: [0, 0, 9], normal: [0, 0, 1], material: *m}
      """;

  /** By how many display levels a PFM's floats may be rounded below white. */
  private static final double FLOAT = 255 * 0x1p-24;

  @TempDir private Path dir;

  @BeforeEach
  void write() throws Exception {
    Files.writeString(dir.resolve("f.yaml"), SCENES);
  }

  /** Renders a scene; returns the RMS of what is missing to white, in levels, and what is said. */
  private double[] missing(String scene, int depth) throws Exception {
    Path stats = dir.resolve("s.json");
    Run run =
        Run.of(
            "render",
            dir.resolve("f.yaml"),
            "--out",
            dir,
            "--scene",
            scene,
            "--depth",
            depth,
            "--samples",
            1,
            "--format",
            "pfm",
            "--stats",
            stats);
    assertEquals(0, run.exitCode(), run.err());
    double sum = 0;
    double[] rgb = ImageFiles.read(dir.resolve(scene + ".pfm"), Transfer.SRGB).rgb();
    for (double v : rgb) {
      double d = Transfer.SRGB.level(1) - Transfer.SRGB.level(v);
      sum += d * d;
    }
    JsonObject all = JsonParser.parseString(Files.readString(stats)).getAsJsonObject();
    JsonObject only = all.getAsJsonArray("scenes").get(0).getAsJsonObject();
    double said = only.getAsJsonObject("error").get("truncation").getAsDouble();
    return new double[] {Math.sqrt(sum / rgb.length), said};
  }

  @Test
  void aLosslessBallIsInvisibleAndLacksNoMoreThanIsSaid() throws Exception {
    for (int depth = 1; depth <= 32; depth++) {
      double[] m = missing("ball", depth);
      assertTrue(m[0] <= m[1] + FLOAT, m[0] + " levels are missing, " + m[1] + " are said");
      assertTrue(m[1] <= 1.001 * m[0] + FLOAT, "said is no more than is missing");
    }
    double[] deep = missing("ball", 400);
    assertEquals(0, deep[0]);
    assertTrue(deep[1] < 1e-9, deep[1] + " levels are said to be missing");
  }

  @Test
  void whereLightHasNoBoundTheRangeOfTheDisplayIsSaid() throws Exception {
    for (int depth = 0; depth < 3; depth++) {
      double[] m = missing("mirrors", depth);
      double level = Transfer.SRGB.level(0.25 * (depth + 1));
      assertEquals(255 - level, m[1], 1e-9);
      assertEquals(255 - level, m[0], FLOAT);
    }
    assertEquals(0, missing("mirrors", 3)[1]);
  }
}

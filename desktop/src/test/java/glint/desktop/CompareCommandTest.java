package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import glint.color.Transfer;
import glint.image.Image;
import glint.io.Pfm;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CompareCommandTest {

  @TempDir private Path dir;

  private Path pfm(String name, int width, int height, double... values) throws IOException {
    Image image = new Image(width, height);
    for (int i = 0; i < width * height; i++) {
      double v = values[i % values.length];
      image.set(i % width, i / width, v, v, v);
    }
    Path file = dir.resolve(name);
    try (OutputStream out = Files.newOutputStream(file)) {
      Pfm.write(image, out);
    }
    return file;
  }

  private static JsonObject json(Run run) {
    assertEquals(0, run.exitCode(), run.err());
    return JsonParser.parseString(run.out()).getAsJsonObject();
  }

  @Test
  void jsonHasTheNamesOfTheContractAndTheRightFigures() throws IOException {
    Path a = pfm("a.pfm", 4, 3, 0.5, 0.25);
    Path b = pfm("b.pfm", 4, 3, 0.5);
    JsonObject json = json(Run.of("compare", a, b, "--json"));
    Set<String> names =
        Set.of(
            "rmse", "max", "mae", "mrse", "psnr", "ssim", "flip", "levels", "width", "height",
            "invalid", "worst");
    assertEquals(names, json.keySet());
    assertEquals(0.25, json.get("max").getAsDouble());
    assertEquals(0.125, json.get("mae").getAsDouble());
    assertEquals(Math.sqrt(0.03125), json.get("rmse").getAsDouble(), 1e-15);
    assertEquals(Set.of("mean", "p99"), json.getAsJsonObject("flip").keySet());
    double levels = 255 * (Transfer.SRGB.encode(0.5) - Transfer.SRGB.encode(0.25));
    assertEquals(levels, json.getAsJsonObject("levels").get("max").getAsDouble(), 1e-12);
    assertEquals("[1,0,0.25]", json.getAsJsonArray("worst").get(0).toString());
    assertEquals(10, json.getAsJsonArray("worst").size());
  }

  @Test
  void psnrOfEqualImagesIsNull() throws IOException {
    Path a = pfm("a.pfm", 2, 2, 0.5);
    assertTrue(json(Run.of("compare", a, a, "--json")).get("psnr").isJsonNull());
    assertTrue(Run.of("compare", a, a).out().contains("psnr"));
  }

  /** Every pixel has sRGB code 51 = 0.2 or, where the format is too coarse, black and white. */
  @ParameterizedTest
  @CsvSource({"1, 0.2", "2, 0.2", "5, 0.2", "6, 0.2", "10, 0.2", "11, 0.2", "12, 1", "13, 0.2"})
  void anyKindOfPngIsRead(int bufferedImageType, double encoded) throws IOException {
    BufferedImage image = new BufferedImage(3, 2, bufferedImageType);
    int bands = image.getRaster().getNumBands();
    int bits = image.getSampleModel().getSampleSize(0);
    int[] pixel = new int[bands];
    Arrays.fill(pixel, (int) Math.round(encoded * ((1 << bits) - 1)));
    if (bufferedImageType == BufferedImage.TYPE_BYTE_INDEXED) {
      Graphics2D graphics = image.createGraphics();
      graphics.setColor(new Color(51, 51, 51));
      graphics.fillRect(0, 0, 3, 2);
      graphics.dispose();
    } else {
      for (int i = 0; i < 6; i++) {
        image.getRaster().setPixel(i % 3, i / 3, pixel);
      }
    }
    Path png = dir.resolve("a.png");
    assertTrue(ImageIO.write(image, "png", png.toFile()));
    Path expected = pfm("b.pfm", 3, 2, Transfer.SRGB.decode(encoded));
    JsonObject json = json(Run.of("compare", png, expected, "--json"));
    assertTrue(json.get("max").getAsDouble() < 1e-8, json.toString());
    Path linear = pfm("c.pfm", 3, 2, encoded);
    json = json(Run.of("compare", png, linear, "--json", "--transfer", "linear"));
    assertTrue(json.get("max").getAsDouble() < 1e-8, json.toString());
  }

  @Test
  void channelsKeepTheirPlaces() throws Exception {
    BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_3BYTE_BGR);
    image.setRGB(0, 0, 0xff0033);
    Path png = dir.resolve("a.png");
    ImageIO.write(image, "png", png.toFile());
    double[] rgb = ImageFiles.read(png, Transfer.LINEAR).rgb();
    assertEquals("[1.0, 0.0, 0.2]", Arrays.toString(rgb));
  }

  @Test
  void sizesMustAgree() throws IOException {
    Run run = Run.of("compare", pfm("a.pfm", 2, 3, 1), pfm("b.pfm", 3, 2, 1));
    assertEquals(1, run.exitCode());
    assertEquals(1, run.errLines().size());
    assertTrue(run.err().matches("(?s).*a\\.pfm has 2x3 pixels, but .*b\\.pfm has 3x2\\R"));
  }

  @Test
  void whatIsNoImageIsNamedInOneLine() throws IOException {
    Path good = pfm("good.pfm", 2, 2, 1);
    byte[] pfm = Files.readAllBytes(good);
    Path png = dir.resolve("good.png");
    ImageIO.write(new BufferedImage(50, 50, BufferedImage.TYPE_INT_RGB), "png", png.toFile());
    byte[] whole = Files.readAllBytes(png);
    byte[] damaged = whole.clone();
    Arrays.fill(damaged, 40, 60, (byte) 0x55);
    byte[][] bad = {
      {},
      {(byte) 0x89},
      "hello".getBytes(java.nio.charset.StandardCharsets.UTF_8),
      Arrays.copyOf(pfm, pfm.length - 1),
      "PF\n-1 3\n-1\n".getBytes(java.nio.charset.StandardCharsets.UTF_8),
      Arrays.copyOf(whole, 20),
      Arrays.copyOf(whole, 60),
      damaged,
      hugePng(),
    };
    for (int i = 0; i < bad.length; i++) {
      Path file = Files.write(dir.resolve("bad" + i), bad[i]);
      assertOneLine(Run.of("compare", file, good), file);
      assertOneLine(Run.of("compare", good, file, "--json"), file);
    }
    assertOneLine(Run.of("compare", good, dir), dir);
    assertOneLine(Run.of("compare", good, dir.resolve("nowhere")), dir.resolve("nowhere"));
    assertEquals(2, Run.of("compare", good, good, "--transfer", "gamma").exitCode());
    assertEquals(2, Run.of("compare", good).exitCode());
  }

  private static void assertOneLine(Run run, Path file) {
    assertEquals(1, run.exitCode(), run.out());
    assertEquals("", run.out());
    assertEquals(1, run.errLines().size(), run.err());
    assertTrue(run.err().startsWith("glint: " + file + ": "), run.err());
    assertFalse(run.err().contains("Exception"), run.err());
    assertEquals(run.err().indexOf(file.toString()), run.err().lastIndexOf(file.toString()));
  }

  /** A PNG of a few bytes whose header claims 50000 x 50000 pixels. */
  private static byte[] hugePng() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    java.io.DataOutputStream data = new java.io.DataOutputStream(out);
    data.writeLong(0x89504e470d0a1a0aL);
    byte[] header = {'I', 'H', 'D', 'R', 0, 0, -61, 80, 0, 0, -61, 80, 8, 2, 0, 0, 0};
    CRC32 check = new CRC32();
    check.update(header);
    data.writeInt(13);
    data.write(header);
    data.writeInt((int) check.getValue());
    return out.toByteArray();
  }
}

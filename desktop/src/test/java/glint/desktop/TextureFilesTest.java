package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.image.ByteImage;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.CRC32;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Images of all kinds become eight-bit codes, and broken ones clear errors. */
class TextureFilesTest {

  private final List<String> remarks = new ArrayList<>();

  private static byte[] write(BufferedImage image, String format) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    assertTrue(ImageIO.write(image, format, out));
    return out.toByteArray();
  }

  private ByteImage decode(byte[] bytes) throws IOException {
    return TextureFiles.decode(new ByteArrayInputStream(bytes), remarks::add);
  }

  private static List<Integer> codes(ByteImage image) {
    List<Integer> codes = new ArrayList<>();
    for (int i = 0; i < 3 * image.width() * image.height(); i++) {
      codes.add(image.code(i / 3 % image.width(), i / 3 / image.width(), i % 3));
    }
    return codes;
  }

  /** Returns an image of two columns and one row. */
  private static BufferedImage two(int type, int[] left, int[] right) {
    BufferedImage image = new BufferedImage(2, 1, type);
    image.getRaster().setPixel(0, 0, left);
    image.getRaster().setPixel(1, 0, right);
    return image;
  }

  @Test
  void colours() throws IOException {
    int[] left = {1, 128, 255};
    int[] right = {254, 0, 7};
    List<Integer> expected = List.of(1, 128, 255, 254, 0, 7);
    byte[] rgb = write(two(BufferedImage.TYPE_INT_RGB, left, right), "png");
    assertEquals(expected, codes(decode(rgb)));
    byte[] bgr = write(two(BufferedImage.TYPE_3BYTE_BGR, left, right), "png");
    assertEquals(expected, codes(decode(bgr)));
    assertEquals(List.of(), remarks);
  }

  @Test
  void alphaIsLeftAsideAndTold() throws IOException {
    int[] left = {1, 128, 255, 255};
    byte[] opaque = write(two(BufferedImage.TYPE_INT_ARGB, left, left), "png");
    assertEquals(List.of(1, 128, 255, 1, 128, 255), codes(decode(opaque)));
    assertEquals(List.of(), remarks);
    int[] right = {254, 0, 7, 0};
    byte[] clear = write(two(BufferedImage.TYPE_INT_ARGB, left, right), "png");
    assertEquals(List.of(1, 128, 255, 254, 0, 7), codes(decode(clear)));
    assertEquals(List.of("is transparent in places, which has no effect here"), remarks);
  }

  @Test
  void grey() throws IOException {
    byte[] bytes = write(two(BufferedImage.TYPE_BYTE_GRAY, new int[] {1}, new int[] {200}), "png");
    assertEquals(List.of(1, 1, 1, 200, 200, 200), codes(decode(bytes)));
    byte[] bits = write(two(BufferedImage.TYPE_BYTE_BINARY, new int[] {0}, new int[] {1}), "png");
    assertEquals(List.of(0, 0, 0, 255, 255, 255), codes(decode(bits)));
  }

  @Test
  void sixteenBitsAreRounded() throws IOException {
    // 257 is code 1; half of that lies between 0 and 1.
    int[] left = {128 * 257 + 128};
    int[] right = {128 * 257 + 129};
    byte[] bytes = write(two(BufferedImage.TYPE_USHORT_GRAY, left, right), "png");
    assertEquals(List.of(128, 128, 128, 129, 129, 129), codes(decode(bytes)));
  }

  @Test
  void palettes() throws IOException {
    byte[] r = {1, (byte) 200, 3, 4};
    byte[] g = {5, 6, (byte) 255, 8};
    byte[] b = {9, 10, 11, 12};
    for (int bits : new int[] {2, 8}) {
      IndexColorModel palette = new IndexColorModel(bits, 4, r, g, b);
      int type = bits < 8 ? BufferedImage.TYPE_BYTE_BINARY : BufferedImage.TYPE_BYTE_INDEXED;
      BufferedImage image = new BufferedImage(2, 1, type, palette);
      image.getRaster().setPixel(0, 0, new int[] {1});
      image.getRaster().setPixel(1, 0, new int[] {2});
      assertEquals(List.of(200, 6, 10, 3, 255, 11), codes(decode(write(image, "png"))));
    }
    assertEquals(List.of(), remarks);
    byte[] alpha = {-1, 0, -1, -1};
    BufferedImage holes =
        new BufferedImage(
            1, 1, BufferedImage.TYPE_BYTE_INDEXED, new IndexColorModel(8, 4, r, g, b, alpha));
    holes.getRaster().setPixel(0, 0, new int[] {1});
    decode(write(holes, "png"));
    assertEquals(1, remarks.size());
  }

  @Test
  void jpegs() throws IOException {
    BufferedImage image = new BufferedImage(16, 8, BufferedImage.TYPE_INT_RGB);
    BufferedImage grey = new BufferedImage(16, 8, BufferedImage.TYPE_BYTE_GRAY);
    for (int i = 0; i < 128; i++) {
      image.setRGB(i % 16, i / 16, 0x6480c8);
      grey.getRaster().setSample(i % 16, i / 16, 0, 90);
    }
    ByteImage read = decode(write(image, "jpeg"));
    assertEquals("16x8", read.width() + "x" + read.height());
    assertEquals(0x64, read.code(5, 5, 0), 3);
    assertEquals(0x80, read.code(5, 5, 1), 3);
    assertEquals(0xc8, read.code(5, 5, 2), 3);
    assertEquals(List.of(90, 90, 90), codes(decode(write(grey, "jpeg"))).subList(0, 3));
    assertEquals(List.of(), remarks);
  }

  @Test
  void inksAreNoLight() throws IOException {
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    WritableRaster cmyk = Raster.createInterleavedRaster(0, 8, 8, 4, null);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
      writer.setOutput(stream);
      writer.write(new IIOImage(cmyk, null, null));
    } finally {
      writer.dispose();
    }
    String told = "neither grey nor of red, green and blue; of inks (CMYK)?";
    byte[] plain = out.toByteArray();
    assertEquals(told, reason(plain));
    // Most programs mark such files as Adobe's.
    ByteBuffer marked = ByteBuffer.allocate(plain.length + 16).put(plain, 0, 2);
    marked.putShort((short) 0xffee).putShort((short) 14);
    marked.put("Adobe".getBytes(StandardCharsets.US_ASCII)).put(new byte[] {0, 100, 0, 0, 0, 0, 0});
    marked.put(plain, 2, plain.length - 2);
    assertEquals(told, reason(marked.array()));
  }

  private String reason(byte[] bytes) {
    return Reasons.of(assertThrows(IOException.class, () -> decode(bytes)));
  }

  @Test
  void otherFilesAreNoImages() throws IOException {
    assertEquals("neither a PNG nor a JPEG image", reason(new byte[0]));
    assertEquals("neither a PNG nor a JPEG image", reason(new byte[] {(byte) 0x89}));
    BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
    assertEquals("neither a PNG nor a JPEG image", reason(write(image, "gif")));
  }

  /** Returns the begin of a PNG file of a size, without its pixels. */
  private static byte[] header(int width, int height) {
    ByteBuffer chunk = ByteBuffer.allocate(17);
    chunk.put("IHDR".getBytes(StandardCharsets.US_ASCII)).putInt(width).putInt(height);
    chunk.put(new byte[] {8, 2, 0, 0, 0});
    CRC32 sum = new CRC32();
    sum.update(chunk.array());
    ByteBuffer file = ByteBuffer.allocate(33);
    file.putLong(0x89504e470d0a1a0aL).putInt(13).put(chunk.array()).putInt((int) sum.getValue());
    return file.array();
  }

  @Test
  void whatIsTooLargeIsNotEvenBegun() {
    assertEquals(
        "it has 100000x100000 pixels; up to 67108864 are read", reason(header(100_000, 100_000)));
    assertTrue(reason(header(8000, 8000)).length() > 0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"png", "jpeg"})
  void whateverIsBrokenIsAnErrorOrToldOrAnImage(String format) throws IOException {
    BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
    Random random = new Random(7);
    for (int i = 0; i < 1200; i++) {
      image.setRGB(i % 40, i / 40, random.nextInt());
    }
    byte[] good = write(image, format);
    for (int cut = 0; cut < good.length; cut += 97) {
      tryOut(Arrays.copyOf(good, cut));
    }
    for (int i = 0; i < 300; i++) {
      byte[] bad = good.clone();
      for (int k = random.nextInt(4); k >= 0; k--) {
        bad[random.nextInt(i % 2 == 0 ? 100 : bad.length)] = (byte) random.nextInt();
      }
      tryOut(bad);
    }
    byte[] half = Arrays.copyOf(good, good.length / 2);
    remarks.clear();
    if (format.equals("png")) {
      assertThrows(IOException.class, () -> decode(half));
    } else {
      decode(half);
      assertTrue(remarks.get(0).startsWith("is damaged: "), remarks.toString());
    }
  }

  private void tryOut(byte[] bytes) {
    try {
      assertTrue(decode(bytes).width() > 0);
    } catch (IOException e) {
      assertTrue(Reasons.of(e).length() > 3, Reasons.of(e));
    }
  }

  @Test
  void anImageBelongsToItsScene(@TempDir Path dir) throws IOException {
    Path picture = dir.resolve("a.png");
    Path file = dir.resolve("a.yaml");
    Files.writeString(
        file,
        """
        scenes:
          s:
            image: {width: 8, height: 8}
            camera: {position: [0, 0, 5], look_at: [0, 0, 0], orthographic: 2}
            lights: [{ambient: {color: 1}}]
            surfaces:
              - quad: {corner: [-1, -1, 0], edge1: [2, 0, 0], edge2: [0, 2, 0], material: {texture: {image: a.png}}}
        """);
    Run check = Run.of("check", file);
    String place = file + ":7:101: note: image 'a.png' ";
    assertEquals(0, check.exitCode(), check.err());
    assertTrue(
        check
            .out()
            .startsWith(
                place + "cannot be read: no such file or folder; magenta stands in for it\n"),
        check.out());
    Path out = dir.resolve("out");
    assertEquals(0, render(file, out).exitCode());
    assertEquals(0xffff00ff, ImageIO.read(out.resolve("s.png").toFile()).getRGB(4, 4));
    Files.write(picture, write(two(1, new int[] {9, 8, 7}, new int[] {9, 8, 7}), "png"));
    assertEquals(0, render(file, out).exitCode());
    assertEquals(0xff090807, ImageIO.read(out.resolve("s.png").toFile()).getRGB(4, 4));
    assertTrue(render(file, out, "--resume").err().contains("kept"));
    Files.write(picture, write(two(1, new int[] {7, 8, 9}, new int[] {7, 8, 9}), "png"));
    assertEquals(0, render(file, out, "--resume").exitCode());
    assertEquals(0xff070809, ImageIO.read(out.resolve("s.png").toFile()).getRGB(4, 4));
    Files.writeString(picture, "no image");
    assertTrue(Run.of("check", file).out().startsWith(place + "cannot be read: neither a PNG"));
    assertTrue(
        Run.of("plan", file).out().matches("(?s).*images +yes +surfaces that show one: 1.*"));
  }

  private static Run render(Path file, Path out, Object... options) {
    List<Object> args = new ArrayList<>(List.of("render", file, "--out", out, "--samples", 1));
    args.addAll(Arrays.asList(options));
    return Run.of(args.toArray());
  }
}

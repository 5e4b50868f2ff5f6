package glint.io;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.image.Image;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PfmTest {

  @Test
  void writesHeaderAndLittleEndianFloatsFromTheBottomRow() throws IOException {
    Image image = new Image(2, 2);
    for (int i = 0; i < 12; i++) {
      image.rgb()[i] = i;
    }
    byte[] expected =
        file("PF\n2 2\n-1.0\n", ByteOrder.LITTLE_ENDIAN, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5);
    assertArrayEquals(expected, written(image));
  }

  @Test
  void writesTheNearestFloat() throws IOException {
    Image image = new Image(1, 1);
    double halfway = 1 + 0x1p-24; // between the floats 1 and 1 + 2^-23: to even
    image.set(0, 0, halfway, Math.nextUp(halfway), 1e300);
    Image back = read(written(image));
    assertArrayEquals(new double[] {1, 1 + 0x1p-23, Double.POSITIVE_INFINITY}, back.rgb());
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "5, 3", "4096, 2", "4095, 3", "1, 70000", "70000, 1", "300, 301"})
  void readsBackWhatItWrote(int width, int height) throws IOException {
    Image image = new Image(width, height);
    for (int i = 0; i < image.rgb().length; i++) {
      image.rgb()[i] = (float) (i * 0.37 - 100);
    }
    image.rgb()[0] = Double.NaN;
    image.rgb()[1] = Double.NEGATIVE_INFINITY;
    image.rgb()[2] = Float.MIN_VALUE;
    Image back = read(written(image));
    assertEquals(width, back.width());
    assertEquals(height, back.height());
    assertArrayEquals(image.rgb(), back.rgb());
  }

  @Test
  void readsBothByteOrders() throws IOException {
    double[] expected = {4, 5, 6, 1, 2, 3};
    byte[] little = file("PF\n1 2\n-1\n", ByteOrder.LITTLE_ENDIAN, 1, 2, 3, 4, 5, 6);
    byte[] big = file("PF\n1 2\n1\n", ByteOrder.BIG_ENDIAN, 1, 2, 3, 4, 5, 6);
    assertArrayEquals(expected, read(little).rgb());
    assertArrayEquals(expected, read(big).rgb());
  }

  @Test
  void readsGreyAsThreeEqualChannels() throws IOException {
    Image image = read(file("Pf\n2 1\n1.0\n", ByteOrder.BIG_ENDIAN, 0.5f, -3));
    assertArrayEquals(new double[] {0.5, 0.5, 0.5, -3, -3, -3}, image.rgb());
  }

  @ParameterizedTest
  @ValueSource(strings = {"2.5", "+1", "1e-3", ".5", "1.", "179.0E+2"})
  void ignoresTheMagnitudeOfTheScale(String scale) throws IOException {
    byte[] big = file("Pf 1\t1\r\n" + scale + " ", ByteOrder.BIG_ENDIAN, 42);
    assertEquals(42, read(big).rgb()[0]);
  }

  @Test
  void oneWhiteSpaceCharacterEndsTheHeader() throws IOException {
    // The first pixel's first byte is a line feed as well
    float pixel = Float.intBitsToFloat(0x0a0a0a0a);
    byte[] file = file("Pf\n1 1\n1\n", ByteOrder.BIG_ENDIAN, pixel);
    assertEquals(pixel, read(file).rgb()[0]);
  }

  @Test
  void readsAStreamThatGivesAFewBytesAtATime() throws IOException {
    byte[] file = file("Pf\n2 1\n-1\n", ByteOrder.LITTLE_ENDIAN, 7, 8);
    InputStream trickle =
        new ByteArrayInputStream(file) {
          @Override
          public int read(byte[] bytes, int offset, int length) {
            return super.read(bytes, offset, Math.min(length, 3));
          }
        };
    assertArrayEquals(new double[] {7, 7, 7, 8, 8, 8}, Pfm.read(trickle, "slow.pfm").rgb());
  }

  @ParameterizedTest
  @CsvSource(
      delimiterString = " -> ",
      emptyValue = "",
      value = {
        "'' -> it does not begin with PF or Pf",
        "P -> it does not begin with PF or Pf",
        "XF|1 1|-1|123456789012 -> it does not begin with PF or Pf",
        "P6|1 1|255| -> it does not begin with PF or Pf",
        "PFM|1 1|-1| -> it does not begin with PF or Pf",
        "PF| -> it ends within the header",
        "PF|1 1|-1 -> it ends within the header",
        "PF|0 1|-1| -> width '0' is not a positive integer of at most 9 digits",
        "PF|1 -1|-1| -> height '-1' is not a positive integer of at most 9 digits",
        "PF|1 1.5|-1| -> height '1.5' is not a positive integer of at most 9 digits",
        "PF|1 9999999999|-1| ->"
            + " height '9999999999' is not a positive integer of at most 9 digits",
        "PF|# 1 1|-1| -> width '#' is not a positive integer of at most 9 digits",
        "PF|1 1|0| -> scale '0' is not a number other than 0",
        "PF|1 1|-0.0e5| -> scale '-0.0e5' is not a number other than 0",
        "PF|1 1|NaN| -> scale 'NaN' is not a number other than 0",
        "PF|1 1|-1d| -> scale '-1d' is not a number other than 0",
        "PF|1 1|1e-999| -> scale '1e-999' is not a number other than 0",
        "PF|1 123456789012345678901234567890123|-1| -> its header is not text",
        "PF|1 \u00071|-1| -> its header is not text",
        "PF|100000 100000|-1| -> it claims 100000x100000 pixels, too many for an image",
        "PF|999999999 999999999|-1| ->"
            + " it claims 999999999x999999999 pixels, too many for an image",
        "PF|1 1|-1|12345678901 -> 1x1 pixels need 12 bytes, only 11 are there",
        "Pf|2 1|-1|1234567 -> 2x1 pixels need 8 bytes, only 7 are there",
        "Pf|1 1|-1|12345 -> 1x1 pixels need 4 bytes, but more are there",
      })
  void refusesWhatIsNotOneMap(String text, String what) {
    byte[] file = text.replace('|', '\n').getBytes(StandardCharsets.US_ASCII);
    Exception e = assertThrows(IOException.class, () -> read(file));
    assertEquals("a.pfm: not a PFM image: " + what, e.getMessage());
  }

  @Test
  void refusesEveryBeginningOfAMap() throws IOException {
    byte[] file = written(new Image(2, 2));
    for (int length = 0; length < file.length; length++) {
      byte[] beginning = Arrays.copyOf(file, length);
      assertThrows(IOException.class, () -> read(beginning));
    }
  }

  @Test
  void aClaimedSizeTakesNoMemory() {
    // 26000 x 26000 doubles would be 16 GB, more than the test has
    byte[] file = file("PF\n26000 26000\n-1\n", ByteOrder.LITTLE_ENDIAN, 1, 2, 3);
    Exception e = assertThrows(IOException.class, () -> read(file));
    assertTrue(e.getMessage().endsWith("need 8112000000 bytes, only 12 are there"));
  }

  private static Image read(byte[] file) throws IOException {
    return Pfm.read(new ByteArrayInputStream(file), "a.pfm");
  }

  private static byte[] written(Image image) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Pfm.write(image, out);
    return out.toByteArray();
  }

  private static byte[] file(String header, ByteOrder order, float... values) {
    byte[] start = header.getBytes(StandardCharsets.US_ASCII);
    ByteBuffer file = ByteBuffer.allocate(start.length + 4 * values.length).order(order);
    file.put(start);
    for (float value : values) {
      file.putFloat(value);
    }
    return file.array();
  }
}

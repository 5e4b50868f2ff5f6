package glint.io;

import glint.image.Image;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;

/** Reads one portable float map; see {@link Pfm#read}. */
final class PfmReader {

  private static final int PIXELS_PER_BLOCK = 1 << 16;
  private static final int LONGEST_WORD = 32;

  private final InputStream in;
  private final String name;

  PfmReader(InputStream in, String name) {
    this.in = in;
    this.name = name;
  }

  Image read() throws IOException {
    int channels = readMagic();
    int width = readSide("width");
    int height = readSide("height");
    ByteOrder order = readScale() < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    if (3L * width * height > Integer.MAX_VALUE - 8) {
      throw malformed("it claims " + width + "x" + height + " pixels, too many for an image");
    }
    List<byte[]> blocks = readBlocks(width, height, 4 * channels);

    // Place the pixels only now that all of them have come
    Image image = new Image(width, height);
    int x = 0;
    int y = height - 1;
    for (byte[] block : blocks) {
      ByteBuffer pixels = ByteBuffer.wrap(block).order(order);
      while (pixels.hasRemaining()) {
        float r = pixels.getFloat();
        float g = channels == 3 ? pixels.getFloat() : r;
        float b = channels == 3 ? pixels.getFloat() : r;
        image.set(x, y, r, g, b);
        x++;
        if (x == width) {
          x = 0;
          y--;
        }
      }
    }
    return image;
  }

  private int readMagic() throws IOException {
    int first = in.read();
    int second = in.read();
    int third = in.read();
    if (first != 'P' || (second != 'F' && second != 'f') || !isSpace(third)) {
      throw malformed("it does not begin with PF or Pf");
    }
    return second == 'F' ? 3 : 1;
  }

  private int readSide(String side) throws IOException {
    String word = readWord();
    if (!word.matches("[0-9]{1,9}") || Integer.parseInt(word) == 0) {
      throw malformed(side + " '" + word + "' is not a positive integer of at most 9 digits");
    }
    return Integer.parseInt(word);
  }

  private double readScale() throws IOException {
    String word = readWord();
    boolean isNumber = word.matches("[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?");
    if (!isNumber || Double.parseDouble(word) == 0) {
      throw malformed("scale '" + word + "' is not a number other than 0");
    }
    return Double.parseDouble(word);
  }

  /** Reads the next word of the header and the one white-space character that ends it. */
  private String readWord() throws IOException {
    StringBuilder word = new StringBuilder();
    while (true) {
      int c = in.read();
      if (c < 0) {
        throw malformed("it ends within the header");
      } else if (isSpace(c) && word.length() > 0) {
        return word.toString();
      } else if (!isSpace(c) && (c <= ' ' || c > '~' || word.length() == LONGEST_WORD)) {
        throw malformed("its header is not text");
      } else if (!isSpace(c)) {
        word.append((char) c);
      }
    }
  }

  /** Reads all pixels in blocks of whole pixels, none made before the one before it was filled. */
  private List<byte[]> readBlocks(int width, int height, int bytesPerPixel) throws IOException {
    long expected = (long) bytesPerPixel * width * height;
    List<byte[]> blocks = new ArrayList<>();
    long got = 0;
    while (got < expected) {
      long most = (long) bytesPerPixel * PIXELS_PER_BLOCK;
      byte[] block = new byte[(int) Math.min(expected - got, most)];
      int filled = fill(block);
      got += filled;
      if (filled < block.length) {
        throw malformed(needs(width, height, expected) + ", only " + got + " are there");
      }
      blocks.add(block);
    }
    if (in.read() >= 0) {
      throw malformed(needs(width, height, expected) + ", but more are there");
    }
    return blocks;
  }

  private int fill(byte[] block) throws IOException {
    int filled = 0;
    while (filled < block.length) {
      int count = in.read(block, filled, block.length - filled);
      if (count < 0) {
        break;
      }
      filled += count;
    }
    return filled;
  }

  private static String needs(int width, int height, long bytes) {
    return width + "x" + height + " pixels need " + bytes + " bytes";
  }

  private static boolean isSpace(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
  }

  private IOException malformed(String what) {
    return new IOException(name + ": not a PFM image: " + what);
  }
}

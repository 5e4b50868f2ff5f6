package glint.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.Reader;
import java.nio.charset.StandardCharsets;

/** Text as bytes in UTF-8, a block at a time. */
final class Utf8Stream extends InputStream {

  private final Reader text;
  private final char[] block = new char[1 << 13];

  /** How many characters of the block are half of one whose other half is still to come. */
  private int kept;

  private byte[] bytes = {};
  private int at;

  Utf8Stream(Reader text) {
    this.text = text;
  }

  @Override
  public int read() throws IOException {
    return hasMore() ? bytes[at++] & 0xFF : -1;
  }

  @Override
  public int read(byte[] to, int from, int most) throws IOException {
    if (!hasMore()) {
      return -1;
    }
    int count = Math.min(most, bytes.length - at);
    System.arraycopy(bytes, at, to, from, count);
    at += count;
    return count;
  }

  private boolean hasMore() throws IOException {
    while (at == bytes.length) {
      int count = text.read(block, kept, block.length - kept);
      if (count < 0) {
        return false;
      }
      int end = kept + count;
      kept = Character.isHighSurrogate(block[end - 1]) ? 1 : 0;
      bytes = new String(block, 0, end - kept).getBytes(StandardCharsets.UTF_8);
      block[0] = block[end - 1];
      at = 0;
    }
    return true;
  }
}

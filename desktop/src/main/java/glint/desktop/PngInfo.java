package glint.desktop;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.CRC32;

/**
 * What a whole PNG file says of itself, without its pixels (PNG, third edition, section 5).
 *
 * @param record the text under the keyword {@link PngFile#KEYWORD}
 */
record PngInfo(int width, int height, Optional<String> record) {

  private static final long SIGNATURE = 0x89504e470d0a1a0aL;
  private static final int HEADER = 0x49484452;
  private static final int TEXT = 0x74455874;
  private static final int END = 0x49454e44;

  /**
   * Reads a file and checks every chunk of it to the last.
   *
   * @throws IOException if it is not one whole PNG file
   */
  static PngInfo read(Path path) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(Files.newInputStream(path), 1 << 16))) {
      return read(in);
    } catch (EOFException e) {
      throw new IOException("the PNG file ends too early", e);
    }
  }

  private static PngInfo read(DataInputStream in) throws IOException {
    if (in.readLong() != SIGNATURE) {
      throw new IOException("not a PNG file");
    }
    int width = 0;
    int height = 0;
    Optional<String> record = Optional.empty();
    int type = HEADER;
    while (type != END) {
      int length = in.readInt();
      type = in.readInt();
      ByteBuffer data = ByteBuffer.wrap(data(in, type, length));
      if (type == HEADER && length == 13) {
        width = data.getInt();
        height = data.getInt();
      } else if (type == TEXT && record.isEmpty()) {
        record = record(new String(data.array(), StandardCharsets.ISO_8859_1));
      }
    }
    if (in.read() >= 0) {
      throw new IOException("the PNG file does not end where it should");
    }
    return new PngInfo(width, height, record);
  }

  private static byte[] data(DataInputStream in, int type, int length) throws IOException {
    if (length < 0) {
      throw new IOException("the PNG file is damaged");
    }
    byte[] data = in.readNBytes(length);
    CRC32 check = new CRC32();
    check.update(ByteBuffer.allocate(4).putInt(0, type));
    check.update(data);
    if (in.readInt() != (int) check.getValue()) {
      throw new IOException("the PNG file is damaged");
    }
    return data;
  }

  private static Optional<String> record(String keywordAndText) {
    String begin = PngFile.KEYWORD + "\0";
    return keywordAndText.startsWith(begin)
        ? Optional.of(keywordAndText.substring(begin.length()))
        : Optional.empty();
  }
}

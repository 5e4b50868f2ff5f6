package glint.android.apk;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Where in a ZIP file its entries stand (PKWARE APPNOTE 4.3.7, 4.3.12, 4.3.16). */
final class ZipIndex {

  private static final int END = 0x06054b50;
  private static final int END_SIZE = 22;
  private static final int CENTRAL = 0x02014b50;
  private static final int LOCAL = 0x04034b50;

  private ZipIndex() {}

  /**
   * An entry.
   *
   * @param method how it is compressed, 0 for not at all
   * @param data where its bytes begin
   */
  record Entry(String name, int method, long data) {
    /** Returns whether it is kept as it is. */
    boolean isStored() {
      return method == 0;
    }
  }

  /** Returns the entries of a file without a comment. */
  static List<Entry> of(RandomAccessFile file) throws IOException {
    long end = file.length() - END_SIZE;
    expect(file, end, END);
    int count = u16(file, end + 10);
    long at = u32(file, end + 16);
    List<Entry> entries = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      expect(file, at, CENTRAL);
      byte[] name = new byte[u16(file, at + 28)];
      file.seek(at + 46);
      file.readFully(name);
      long local = u32(file, at + 42);
      expect(file, local, LOCAL);
      long data = local + 30 + u16(file, local + 26) + u16(file, local + 28);
      entries.add(new Entry(new String(name, StandardCharsets.UTF_8), u16(file, at + 10), data));
      at += 46 + name.length + u16(file, at + 30) + u16(file, at + 32);
    }
    return entries;
  }

  private static void expect(RandomAccessFile file, long at, int signature) throws IOException {
    if (u32(file, at) != Integer.toUnsignedLong(signature)) {
      throw new EOFException("no " + Integer.toHexString(signature) + " at " + at);
    }
  }

  private static int u16(RandomAccessFile file, long at) throws IOException {
    file.seek(at);
    return Short.toUnsignedInt(Short.reverseBytes(file.readShort()));
  }

  private static long u32(RandomAccessFile file, long at) throws IOException {
    file.seek(at);
    return Integer.toUnsignedLong(Integer.reverseBytes(file.readInt()));
  }
}

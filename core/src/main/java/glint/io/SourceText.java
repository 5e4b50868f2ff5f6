package glint.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** Turns the bytes of a scene file into text, strictly. */
final class SourceText {

  /** The largest scene file, in bytes. */
  static final int MOST_BYTES = 64 << 20;

  private static final int LONGEST_QUOTE = 40;

  private SourceText() {}

  /**
   * Returns the UTF-8 text of a stream without its byte order mark, or null with a problem
   * reported: the file is too large, is not UTF-8 or holds control characters.
   *
   * @throws IOException if the stream fails
   */
  static String read(InputStream in, Problems problems) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    byte[] block = new byte[1 << 16];
    int count = in.read(block);
    while (count >= 0) {
      bytes.write(block, 0, count);
      if (bytes.size() > MOST_BYTES) {
        problems.report(
            Place.NONE, "is too large: scene files hold up to " + (MOST_BYTES >> 20) + " MiB");
        return null;
      }
      count = in.read(block);
    }
    return decode(bytes.toByteArray(), problems);
  }

  private static String decode(byte[] bytes, Problems problems) {
    CharsetDecoder decoder =
        StandardCharsets.UTF_8
            .newDecoder()
            .onMalformedInput(CodingErrorAction.REPORT)
            .onUnmappableCharacter(CodingErrorAction.REPORT);
    ByteBuffer in = ByteBuffer.wrap(bytes);
    CharBuffer out = CharBuffer.allocate(bytes.length);
    CoderResult result = decoder.decode(in, out, true);
    boolean marked = out.position() > 0 && out.get(0) == '\uFEFF';
    String text = new String(out.array(), marked ? 1 : 0, out.position() - (marked ? 1 : 0));
    int control = firstControlCharacter(text);
    if (control < text.length()) {
      String code = hex(text.charAt(control));
      problems.report(
          placeOf(text, control), "holds a control character (" + code + "): not a text file?");
      return null;
    }
    if (result.isError()) {
      String code = hex(bytes[in.position()] & 0xFF);
      problems.report(
          placeOf(text, text.length()), "is not UTF-8 text (byte " + code + "): not a text file?");
      return null;
    }
    return text;
  }

  /** Returns a person's text between quotes, in one line of bearable length. */
  static String quote(String text) {
    return "'" + shorten(text) + "'";
  }

  /** Returns a person's text in one line of bearable length. */
  static String shorten(String text) {
    StringBuilder line = new StringBuilder();
    int end = Math.min(text.length(), LONGEST_QUOTE);
    for (int i = 0; i < end; i++) {
      char c = text.charAt(i);
      line.append(Character.isISOControl(c) || c == '\u2028' || c == '\u2029' ? ' ' : c);
    }
    return line.append(end < text.length() ? "…" : "").toString();
  }

  private static int firstControlCharacter(String text) {
    int i = 0;
    while (i < text.length()) {
      char c = text.charAt(i);
      boolean control = Character.isISOControl(c) && "\t\n\r\u0085".indexOf(c) < 0;
      if (control || c == '\uFFFE' || c == '\uFFFF') {
        break;
      }
      i++;
    }
    return i;
  }

  private static Place placeOf(String text, int index) {
    int line = 1;
    int start = 0;
    for (int i = 0; i < index; i++) {
      char c = text.charAt(i);
      if (c == '\n' || (c == '\r' && !(i + 1 < text.length() && text.charAt(i + 1) == '\n'))) {
        line++;
        start = i + 1;
      }
    }
    return new Place(line, 1 + text.codePointCount(start, index));
  }

  private static String hex(int code) {
    return String.format(Locale.ROOT, "0x%02X", code);
  }
}

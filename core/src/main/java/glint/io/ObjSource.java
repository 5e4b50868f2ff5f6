package glint.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;

/**
 * The bytes of an OBJ file as statements of tokens, which know their places.
 *
 * <p>One pass over a buffer of fixed size. Lines end in LF, CRLF or CR; {@code #} begins a comment;
 * a backslash at the end of a line, unless in a comment, joins it to the next one. Text with a byte
 * order mark may be UTF-8 or UTF-16.
 */
final class ObjSource {

  /** The longest token that is a number or the like. */
  static final int LONGEST = 1024;

  private static final int BUFFER = 1 << 16;
  private static final int MOST_QUOTED = 64;

  /** An index beyond what any mesh holds. */
  private static final long TOO_LARGE = 1_000_000_000;

  private final InputStream in;
  private final Decimal decimal = new Decimal();

  /** The bytes from {@code at} to {@code limit} are still to be read; a line's end follows them. */
  private final byte[] buffer = new byte[BUFFER + 1];

  private int at;
  private int limit;
  private boolean ended;
  private int line = 1;

  /** Where the line begins in the buffer, negative if that has left it. */
  private int lineStart;

  private final int[] corner = new int[3];

  /** Reads what it needs to know the encoding. */
  ObjSource(InputStream bytes) throws IOException {
    int count = 0;
    while (limit < 2 && count >= 0) {
      limit += count;
      count = bytes.read(buffer, limit, 2 - limit);
    }
    if (begins(0xFE, 0xFF)) {
      in = new Utf8Stream(new InputStreamReader(bytes, StandardCharsets.UTF_16BE));
      limit = 0;
    } else if (begins(0xFF, 0xFE)) {
      in = new Utf8Stream(new InputStreamReader(bytes, StandardCharsets.UTF_16LE));
      limit = 0;
    } else {
      in = bytes;
    }
    fill();
    if (begins(0xEF, 0xBB) && buffer[2] == (byte) 0xBF) {
      at = 3;
      lineStart = 3;
    }
  }

  private boolean begins(int first, int second) {
    return limit >= 2 && buffer[0] == (byte) first && buffer[1] == (byte) second;
  }

  /** Moves what is left to the buffer's begin and reads on until any token would be whole. */
  private void fill() throws IOException {
    System.arraycopy(buffer, at, buffer, 0, limit - at);
    lineStart -= at;
    limit -= at;
    at = 0;
    while (!ended && limit <= LONGEST) {
      int count = in.read(buffer, limit, BUFFER - limit);
      ended = count < 0;
      limit += Math.max(0, count);
    }
    buffer[limit] = '\n';
  }

  /** Returns where the next byte stands. */
  Place place() {
    return new Place(line, column());
  }

  int line() {
    return line;
  }

  int column() {
    return at - lineStart + 1;
  }

  /** Returns whether all bytes were read. */
  boolean isAtEnd() {
    return ended && at == limit;
  }

  /** Goes to the next token of this statement; returns whether there is one. */
  boolean hasToken() throws IOException {
    while (true) {
      while (isBlank(buffer[at])) {
        at++;
      }
      if (limit - at <= LONGEST && !ended) {
        fill();
        continue;
      }
      byte c = buffer[at];
      if (c == '\\' && isLastOfLine()) {
        endLine();
      } else {
        return c != '\n' && c != '\r' && c != '#';
      }
    }
  }

  /** Returns whether only blanks follow in this line, and stands at its end if so. */
  private boolean isLastOfLine() {
    int i = at + 1;
    while (isBlank(buffer[i])) {
      i++;
    }
    boolean last = buffer[i] == '\n' || buffer[i] == '\r';
    at = last ? i : at;
    return last;
  }

  /** Steps over the end of a line. */
  private void endLine() throws IOException {
    if (limit - at < 2 && !ended) {
      fill();
    }
    if (at < limit) {
      at += buffer[at] == '\r' && at + 1 < limit && buffer[at + 1] == '\n' ? 2 : 1;
      line++;
      lineStart = at;
    }
  }

  /** Skips what is left of the statement, and its end. */
  void endStatement() throws IOException {
    boolean comment = false;
    byte last = ' ';
    while (true) {
      byte c = buffer[at];
      if (c != '\n' && c != '\r') {
        comment |= c == '#' && isBlank(last);
        last = c;
        at++;
      } else if (at == limit && !ended) {
        fill();
      } else {
        endLine();
        if (comment || last != '\\' || at == limit && ended) {
          return;
        }
        last = ' ';
      }
    }
  }

  /** Steps over a word if that is the next token. */
  boolean takes(String word) {
    int length = word.length();
    if (at + length > limit || !isDelimiter(buffer[at + length])) {
      return false;
    }
    for (int i = 0; i < length; i++) {
      if (buffer[at + i] != word.charAt(i)) {
        return false;
      }
    }
    at += length;
    return true;
  }

  /**
   * Returns the next token for use in a message, and stays before it.
   *
   * @throws BadObj if it holds what no text does
   */
  String word() {
    int end = at;
    do {
      byte c = buffer[end];
      if (c >= 0 && c < ' ' || c == 0x7F) {
        throw BadObj.noText(place(), c);
      }
      end++;
    } while ((buffer[end] == '#' || !isDelimiter(buffer[end])) && end - at < MOST_QUOTED);
    return new String(buffer, at, end - at, StandardCharsets.UTF_8);
  }

  /**
   * Reads the rest of the statement as a name, blanks and {@code #} within it included; "" if there
   * is none.
   *
   * @throws BadObj if it is longer than any name or holds what no text does
   */
  String rest() throws IOException {
    StringBuilder name = new StringBuilder();
    while (hasToken() || buffer[at] == '#') {
      int end = endOfLine();
      int last = lastOf(end);
      boolean goesOn = buffer[last - 1] == '\\' && end < limit;
      String piece = text(at, goesOn ? lastOf(last - 1) : last);
      name.append(name.length() == 0 ? "" : " ").append(piece);
      at = goesOn ? last - 1 : end;
      if (name.length() > LONGEST) {
        throw BadObj.tooLongName(place());
      }
    }
    return name.toString();
  }

  /** Steps back over blanks. */
  private int lastOf(int end) {
    int last = end;
    while (isBlank(buffer[last - 1])) {
      last--;
    }
    return last;
  }

  private int endOfLine() {
    int end = at;
    while (buffer[end] != '\n' && buffer[end] != '\r') {
      byte c = buffer[end];
      if (c >= 0 && c < ' ' && !isBlank(c) || c == 0x7F) {
        throw BadObj.noText(place(), c);
      }
      if (end - at >= LONGEST) {
        throw BadObj.tooLongName(place());
      }
      end++;
    }
    return end;
  }

  /** Returns bytes as text: UTF-8, or what old programs write. */
  private String text(int from, int to) {
    try {
      return StandardCharsets.UTF_8
          .newDecoder()
          .decode(ByteBuffer.wrap(buffer, from, to - from))
          .toString();
    } catch (CharacterCodingException e) {
      return new String(buffer, from, to - from, StandardCharsets.ISO_8859_1);
    }
  }

  /**
   * Reads the next token as a finite number.
   *
   * @throws BadObj if it is none
   */
  double number() {
    boolean isNumber = decimal.read(buffer, at);
    int end = decimal.end();
    // Not a comment, but what some C libraries write for an infinity: 1.#INF
    if (!isNumber || !isDelimiter(buffer[end]) || buffer[end] == '#' && buffer[end - 1] == '.') {
      throw BadObj.noNumber(place(), word());
    }
    if (Double.isInfinite(decimal.value())) {
      throw new BadObj(place(), "too large a number: " + SourceText.quote(word()));
    }
    if (end - at > LONGEST) {
      throw BadObj.tooLong(place());
    }
    at = end;
    return decimal.value();
  }

  /**
   * Reads the next token as a corner of a face: {@code v}, {@code v/vt}, {@code v//vn} or {@code
   * v/vt/vn}, each an index that is not 0.
   *
   * @throws BadObj if it is none
   */
  void corner() {
    int end = at;
    corner[1] = 0;
    corner[2] = 0;
    for (int part = 0; part < 3; part++) {
      int begin = end;
      long index = 0;
      boolean negative = buffer[end] == '-';
      end += negative ? 1 : 0;
      int first = end;
      while (buffer[end] >= '0' && buffer[end] <= '9') {
        index = Math.min(TOO_LARGE, 10 * index + buffer[end] - '0');
        end++;
      }
      if (end - at > LONGEST) {
        throw BadObj.tooLong(place());
      }
      boolean absent = part > 0 && end == begin;
      if (end == first && !absent) {
        break;
      }
      if (index == 0 && !absent) {
        throw BadObj.zeroIndex(place(), word());
      }
      if (index == TOO_LARGE) {
        throw BadObj.noPoint(place(), word());
      }
      corner[part] = (int) (negative ? -index : index);
      if (isDelimiter(buffer[end])) {
        at = end;
        return;
      }
      if (buffer[end] != '/') {
        break;
      }
      end++;
    }
    throw BadObj.noCorner(place(), word());
  }

  /** Returns the index {@code v}, {@code vt} or {@code vn} of the last corner; 0 for none. */
  int index(int part) {
    return corner[part];
  }

  private static boolean isBlank(byte c) {
    return c == ' ' || c == '\t' || c == 0x0B || c == '\f';
  }

  private static boolean isDelimiter(byte c) {
    return isBlank(c) || c == '\n' || c == '\r' || c == '#' || c == '\\';
  }
}

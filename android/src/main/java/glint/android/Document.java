package glint.android;

import android.content.Context;
import android.database.Cursor;
import android.net.Uri;
import android.provider.OpenableColumns;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;

/** What a document provider tells of a file that was picked. */
final class Document {

  /** What the reader of a model holds at its height, for a byte of its file. */
  private static final int OF_A_MODEL = 3;

  /** What the readers of scene files hold. */
  private static final int OF_A_SCENE = 24;

  private Document() {}

  /** Returns what people call a file. */
  static String name(Context context, Uri file) {
    String[] columns = {OpenableColumns.DISPLAY_NAME};
    try (Cursor cursor = context.getContentResolver().query(file, columns, null, null, null)) {
      if (cursor != null && cursor.moveToFirst() && !cursor.isNull(0)) {
        return cursor.getString(0);
      }
    } catch (SecurityException e) {
      // to be told when it is opened
    }
    return String.valueOf(file.getLastPathSegment());
  }

  /** Opens a file; its failures say why in words. */
  static InputStream open(Context context, Uri file) throws IOException {
    try {
      InputStream in = context.getContentResolver().openInputStream(file);
      if (in == null) {
        throw new FileNotFoundException(file.toString());
      }
      return in;
    } catch (SecurityException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /** Refuses a file that would not fit into memory, as far as its size is known. */
  static void checkSize(Context context, Uri file, String name) throws IOException {
    long size = size(context, file);
    long needed = size * (name.endsWith(".obj") ? OF_A_MODEL : OF_A_SCENE);
    long free = Heap.now().bytes();
    if (needed > free) {
      throw new IOException(
          context.getString(
              R.string.too_big_to_read,
              Heap.mebibytes(size),
              Heap.mebibytes(needed),
              Heap.mebibytes(free)));
    }
  }

  private static long size(Context context, Uri file) {
    String[] columns = {OpenableColumns.SIZE};
    try (Cursor cursor = context.getContentResolver().query(file, columns, null, null, null)) {
      return cursor != null && cursor.moveToFirst() && !cursor.isNull(0) ? cursor.getLong(0) : 0;
    } catch (SecurityException e) {
      return 0;
    }
  }
}

package glint.android;

import android.content.ContentResolver;
import android.content.ContentValues;
import android.graphics.Bitmap;
import android.net.Uri;
import android.os.Build;
import android.os.Environment;
import android.provider.MediaStore.Images.Media;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.OutputStream;

/** The pictures of the device's owner, to which the app adds. */
final class Pictures {

  private static final String FOLDER = Environment.DIRECTORY_PICTURES + "/Glint";
  private static final int LOSSLESS = 100;

  private final ContentResolver resolver;

  Pictures(ContentResolver resolver) {
    this.resolver = resolver;
  }

  /** Adds a picture as PNG; returns its address. */
  Uri add(Bitmap bitmap, String name) throws IOException {
    ContentValues values = new ContentValues();
    values.put(Media.DISPLAY_NAME, name + ".png");
    values.put(Media.MIME_TYPE, "image/png");
    boolean scoped = Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q;
    if (scoped) {
      values.put(Media.RELATIVE_PATH, FOLDER);
      values.put(Media.IS_PENDING, 1);
    }
    Uri uri = resolver.insert(Media.EXTERNAL_CONTENT_URI, values);
    if (uri == null) {
      throw new FileNotFoundException(FOLDER);
    }
    try (OutputStream out = resolver.openOutputStream(uri)) {
      if (out == null || !bitmap.compress(Bitmap.CompressFormat.PNG, LOSSLESS, out)) {
        throw new FileNotFoundException(uri.toString());
      }
    } catch (IOException e) {
      resolver.delete(uri, null, null);
      throw e;
    }
    if (scoped) {
      ContentValues finished = new ContentValues();
      finished.put(Media.IS_PENDING, 0);
      resolver.update(uri, finished, null, null);
    }
    return uri;
  }
}

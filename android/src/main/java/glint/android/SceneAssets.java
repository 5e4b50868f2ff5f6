package glint.android;

import android.content.res.AssetManager;
import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import glint.image.ByteImage;
import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.io.SceneFolder;
import java.io.ByteArrayOutputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Consumer;

/** The scene files that are packed into the app, and what they name. */
final class SceneAssets implements SceneFolder {

  private final AssetManager assets;

  SceneAssets(AssetManager assets) {
    this.assets = assets;
  }

  /** Reads one of the scene files. */
  SceneFile read(String name) throws IOException {
    try (InputStream in = assets.open(name)) {
      return SceneFiles.read(in, name, this);
    }
  }

  @Override
  public InputStream open(String path) throws IOException {
    try {
      return assets.open(path);
    } catch (FileNotFoundException e) {
      throw new IOException("no such file", e);
    }
  }

  /** Decodes with the platform's decoder; codes stay as they are, without premultiplied alpha. */
  @Override
  public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    byte[] bytes = all(in);
    BitmapFactory.Options options = new BitmapFactory.Options();
    options.inPremultiplied = false;
    options.inScaled = false;
    options.inJustDecodeBounds = true;
    BitmapFactory.decodeByteArray(bytes, 0, bytes.length, options);
    if (options.outWidth <= 0) {
      throw new IOException("neither a PNG nor a JPEG image");
    }
    try {
      ByteImage.checkSize(options.outWidth, options.outHeight);
    } catch (IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
    options.inJustDecodeBounds = false;
    Bitmap bitmap = BitmapFactory.decodeByteArray(bytes, 0, bytes.length, options);
    if (bitmap == null) {
      throw new IOException("broken");
    }
    return codes(bitmap, remarks);
  }

  private static ByteImage codes(Bitmap bitmap, Consumer<String> remarks) {
    int width = bitmap.getWidth();
    int height = bitmap.getHeight();
    byte[] rgb = new byte[3 * width * height];
    int[] row = new int[width];
    boolean transparent = false;
    int at = 0;
    for (int y = 0; y < height; y++) {
      bitmap.getPixels(row, 0, width, 0, y, width, 1);
      for (int argb : row) {
        transparent |= argb >>> 24 < 255;
        rgb[at++] = (byte) (argb >> 16);
        rgb[at++] = (byte) (argb >> 8);
        rgb[at++] = (byte) argb;
      }
    }
    if (transparent) {
      remarks.accept("is transparent in places, which has no effect here");
    }
    return new ByteImage(width, height, rgb);
  }

  private static byte[] all(InputStream in) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    byte[] block = new byte[1 << 16];
    for (int n = in.read(block); n >= 0; n = in.read(block)) {
      bytes.write(block, 0, n);
    }
    return bytes.toByteArray();
  }
}

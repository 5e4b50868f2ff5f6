package glint.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import android.graphics.Bitmap;
import android.graphics.BitmapFactory;
import java.io.File;

/** The images that the desktop's command has rendered. */
final class Desktop {

  private Desktop() {}

  /** Returns how many there are: one of each scene of the gallery. */
  static int images() {
    return new File(System.getProperty("glint.desktop.images")).list().length;
  }

  /** Compares a bitmap with the desktop's image of a scene, pixel for pixel. */
  static void assertSame(String scene, Bitmap bitmap) {
    File file = new File(System.getProperty("glint.desktop.images"), scene + ".png");
    Bitmap expected = BitmapFactory.decodeFile(file.getPath());
    assertEquals(scene, size(expected), size(bitmap));
    assertArrayEquals(scene, pixels(expected), pixels(bitmap));
  }

  private static String size(Bitmap bitmap) {
    return bitmap.getWidth() + "x" + bitmap.getHeight();
  }

  /** Returns the ARGB codes of a bitmap, row by row. */
  static int[] pixels(Bitmap bitmap) {
    int width = bitmap.getWidth();
    int height = bitmap.getHeight();
    int[] pixels = new int[width * height];
    bitmap.getPixels(pixels, 0, width, 0, 0, width, height);
    return pixels;
  }
}

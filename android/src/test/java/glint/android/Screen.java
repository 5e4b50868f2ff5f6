package glint.android;

import android.app.Activity;
import android.graphics.Bitmap;
import android.graphics.Canvas;
import android.view.View;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/** Pictures of what a person sees. */
final class Screen {

  private Screen() {}

  /** Returns what an activity shows; its surface, which a device shows below, is painted in. */
  static Bitmap of(Activity activity) {
    View all = activity.getWindow().getDecorView();
    Bitmap bitmap = Bitmap.createBitmap(all.getWidth(), all.getHeight(), Bitmap.Config.ARGB_8888);
    Canvas canvas = new Canvas(bitmap);
    all.draw(canvas);
    PictureView picture = activity.findViewById(R.id.picture);
    if (picture != null) {
      int[] at = new int[2];
      picture.getLocationInWindow(at);
      canvas.translate(at[0], at[1]);
      canvas.clipRect(0, 0, picture.getWidth(), picture.getHeight());
      picture.paint(canvas);
    }
    return bitmap;
  }

  /** Writes it as PNG, where the build keeps such pictures. */
  static void write(Bitmap bitmap, String name) throws IOException {
    File folder = new File(System.getProperty("glint.screens"));
    folder.mkdirs();
    try (OutputStream out = new FileOutputStream(new File(folder, name + ".png"))) {
      bitmap.compress(Bitmap.CompressFormat.PNG, 100, out);
    }
  }
}

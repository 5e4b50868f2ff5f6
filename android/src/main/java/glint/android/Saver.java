package glint.android;

import android.Manifest;
import android.app.Activity;
import android.content.Intent;
import android.content.pm.PackageManager;
import android.graphics.Bitmap;
import android.net.Uri;
import android.os.Build;
import android.widget.Toast;
import java.io.IOException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Saves what an activity shows, and shares it. */
final class Saver {

  /** Requests of the permission to write: to save, or to share then. */
  private static final int TO_SAVE = 1;

  private static final int TO_SHARE = 2;

  private final Activity activity;
  private final ExecutorService writer =
      Executors.newSingleThreadExecutor(Threads.of("glint-save", Threads.AWAITED));

  Saver(Activity activity) {
    this.activity = activity;
  }

  /** Saves a picture as it is now, and if asked to opens the ways to share it. */
  void save(Bitmap picture, String name, boolean share) {
    if (mayWrite()) {
      Bitmap copy = picture.copy(picture.getConfig(), false);
      writer.execute(() -> write(copy, name, share));
    } else {
      String[] permission = {Manifest.permission.WRITE_EXTERNAL_STORAGE};
      activity.requestPermissions(permission, share ? TO_SHARE : TO_SAVE);
    }
  }

  /** Goes on after a person has allowed to write, or not. */
  void answered(int request, int[] results, Bitmap picture, String name) {
    if (results.length > 0 && results[0] == PackageManager.PERMISSION_GRANTED) {
      save(picture, name, request == TO_SHARE);
    } else {
      say(activity.getString(R.string.not_allowed));
    }
  }

  /** Lets go of the thread once it has saved. */
  void close() {
    writer.shutdown();
  }

  private boolean mayWrite() {
    return Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q
        || activity.checkSelfPermission(Manifest.permission.WRITE_EXTERNAL_STORAGE)
            == PackageManager.PERMISSION_GRANTED;
  }

  private void write(Bitmap picture, String name, boolean share) {
    try {
      Uri uri = new Pictures(activity.getContentResolver()).add(picture, name);
      activity.runOnUiThread(() -> written(uri, share));
    } catch (IOException | SecurityException e) {
      String why = activity.getString(R.string.not_saved, e.getMessage());
      activity.runOnUiThread(() -> say(why));
    }
  }

  private void written(Uri uri, boolean share) {
    if (share) {
      Intent send = new Intent(Intent.ACTION_SEND).setType("image/png");
      send.putExtra(Intent.EXTRA_STREAM, uri).addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION);
      activity.startActivity(Intent.createChooser(send, null));
    } else {
      say(activity.getString(R.string.saved));
    }
  }

  private void say(String text) {
    Toast.makeText(activity, text, Toast.LENGTH_LONG).show();
  }
}

package glint.android;

import android.content.Context;
import android.net.Uri;
import android.os.Handler;
import android.os.Looper;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;

/** Reads scene files on a thread of its own, and keeps what it read last. */
final class Library {

  private final Context context;
  private final ExecutorService reader =
      Executors.newSingleThreadExecutor(Threads.of("glint-read", Threads.AWAITED));
  private final Handler main = new Handler(Looper.getMainLooper());

  private Uri kept;
  private Reading reading;

  Library(Context context) {
    this.context = context;
  }

  /** Reads a file, if it is not the one that is kept; hands its scenes over on the main thread. */
  void read(Uri file, Consumer<Reading> receiver) {
    reader.execute(
        () -> {
          Reading found = find(file);
          main.post(() -> receiver.accept(found));
        });
  }

  private synchronized Reading find(Uri file) {
    if (!file.equals(kept)) {
      forget();
      reading = new SceneReader(context).read(file);
      kept = file;
    }
    return reading;
  }

  /** Lets go of what was read. */
  synchronized void forget() {
    kept = null;
    reading = null;
  }
}

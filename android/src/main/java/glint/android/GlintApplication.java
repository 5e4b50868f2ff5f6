package glint.android;

import android.app.Application;
import android.content.Context;

/** What lives as long as the app's process: the scenes that were read. */
public final class GlintApplication extends Application {

  private final Library library = new Library(this);

  /** Returns the scenes of the app. */
  static Library library(Context context) {
    return ((GlintApplication) context.getApplicationContext()).library;
  }

  @Override
  public void onTrimMemory(int level) {
    super.onTrimMemory(level);
    if (level >= TRIM_MEMORY_RUNNING_CRITICAL) {
      library.forget();
    }
  }
}

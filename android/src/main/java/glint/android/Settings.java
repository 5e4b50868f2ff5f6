package glint.android;

import android.content.Context;
import android.content.SharedPreferences;
import glint.scene.Scene;

/**
 * What a person has chosen for all renders; immutable.
 *
 * @param levels the error to render to, in display levels
 * @param threads workers, 1 to the number of the device's cores
 * @param size of pictures
 */
record Settings(float levels, int threads, Size size) {

  /** The errors that can be chosen, in display levels. */
  static final float[] LEVELS = {8, 4, 2, 1, 0.5f, 0.25f};

  private static final float DEFAULT_LEVELS = 1;
  private static final String FILE = "settings";
  private static final String LEVELS_KEY = "levels";
  private static final String THREADS_KEY = "threads";
  private static final String SIZE_KEY = "size";

  /** A size of pictures. */
  enum Size {
    SCENE(0, 0),
    W160(160, 120),
    W320(320, 240),
    W640(640, 480),
    W1280(1280, 720),
    W1920(1920, 1080);

    private final int columns;
    private final int rows;

    Size(int columns, int rows) {
      this.columns = columns;
      this.rows = rows;
    }

    /** Returns the columns, 0 if the scene decides. */
    int columns() {
      return columns;
    }

    /** Returns the rows, 0 if the scene decides. */
    int rows() {
      return rows;
    }

    /** Returns the columns of a scene's picture. */
    int width(Scene scene) {
      return this == SCENE ? scene.width() : columns;
    }

    /** Returns the rows of a scene's picture. */
    int height(Scene scene) {
      return this == SCENE ? scene.height() : rows;
    }
  }

  /** Returns the place of an error among those that can be chosen. */
  static int indexOf(float levels) {
    int index = 0;
    while (index < LEVELS.length - 1 && LEVELS[index] > levels) {
      index++;
    }
    return index;
  }

  /** Returns the number of threads that are of use. */
  static int mostThreads() {
    return Runtime.getRuntime().availableProcessors();
  }

  /** Returns what was chosen last, or else the defaults. */
  static Settings load(Context context) {
    SharedPreferences file = file(context);
    return new Settings(
        file.getFloat(LEVELS_KEY, DEFAULT_LEVELS),
        Math.min(mostThreads(), file.getInt(THREADS_KEY, mostThreads())),
        Size.valueOf(file.getString(SIZE_KEY, Size.SCENE.name())));
  }

  /** Keeps the choice. */
  void save(Context context) {
    file(context)
        .edit()
        .putFloat(LEVELS_KEY, levels)
        .putInt(THREADS_KEY, threads)
        .putString(SIZE_KEY, size.name())
        .apply();
  }

  private static SharedPreferences file(Context context) {
    return context.getSharedPreferences(FILE, Context.MODE_PRIVATE);
  }
}

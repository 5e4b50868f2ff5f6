package glint.android;

import android.app.Activity;
import android.os.Bundle;
import android.widget.ArrayAdapter;
import android.widget.Spinner;
import java.text.NumberFormat;
import java.util.ArrayList;
import java.util.List;

/** Lets a person choose how to render; what is chosen is kept when the screen is left. */
public final class SettingsActivity extends Activity {

  private Spinner levels;
  private Spinner threads;
  private Spinner size;

  @Override
  protected void onCreate(Bundle state) {
    super.onCreate(state);
    setContentView(R.layout.settings);
    getActionBar().setDisplayHomeAsUpEnabled(true);
    Settings now = Settings.load(this);
    levels = spinner(R.id.levels, levels(), Settings.indexOf(now.levels()));
    threads = spinner(R.id.threads, threads(), now.threads() - 1);
    size = spinner(R.id.size, sizes(), now.size().ordinal());
  }

  private Spinner spinner(int id, List<String> words, int chosen) {
    Spinner spinner = findViewById(id);
    ArrayAdapter<String> adapter =
        new ArrayAdapter<>(this, android.R.layout.simple_spinner_item, words);
    adapter.setDropDownViewResource(android.R.layout.simple_spinner_dropdown_item);
    spinner.setAdapter(adapter);
    spinner.setSelection(chosen);
    return spinner;
  }

  private List<String> levels() {
    List<String> words = new ArrayList<>();
    for (float each : Settings.LEVELS) {
      words.add(NumberFormat.getInstance().format(each));
    }
    return words;
  }

  private List<String> threads() {
    List<String> words = new ArrayList<>();
    for (int count = 1; count <= Settings.mostThreads(); count++) {
      words.add(getResources().getQuantityString(R.plurals.thread_count, count, count));
    }
    return words;
  }

  private List<String> sizes() {
    List<String> words = new ArrayList<>();
    for (Settings.Size each : Settings.Size.values()) {
      words.add(
          each == Settings.Size.SCENE
              ? getString(R.string.size_of_scene)
              : getString(R.string.size, each.columns(), each.rows()));
    }
    return words;
  }

  @Override
  protected void onPause() {
    super.onPause();
    new Settings(
            Settings.LEVELS[levels.getSelectedItemPosition()],
            threads.getSelectedItemPosition() + 1,
            Settings.Size.values()[size.getSelectedItemPosition()])
        .save(this);
  }
}

package glint.android;

import android.app.Activity;
import android.content.ActivityNotFoundException;
import android.content.Intent;
import android.net.Uri;
import android.os.Bundle;
import android.text.TextUtils;
import android.view.Menu;
import android.view.MenuItem;
import android.view.View;
import android.widget.ListView;
import android.widget.TextView;
import android.widget.Toast;
import glint.scene.Scene;

/** Lists the scenes of the gallery, or of a file that was picked. */
public final class MainActivity extends Activity {

  private static final String FILE = "file";
  private static final int PICK = 1;

  private TextView message;
  private SceneAdapter scenes;
  private Thumbnails thumbnails;
  private Uri file;

  @Override
  protected void onCreate(Bundle state) {
    super.onCreate(state);
    setContentView(R.layout.main);
    message = findViewById(R.id.message);
    Thumbnails kept = (Thumbnails) getLastNonConfigurationInstance();
    thumbnails = kept == null ? new Thumbnails(new ThumbnailCache(this)) : kept;
    scenes = new SceneAdapter(this);
    ListView list = findViewById(R.id.scenes);
    list.setAdapter(scenes);
    list.setOnItemClickListener((parent, row, position, id) -> open(scenes.getItem(position)));
    read(state == null ? SceneReader.GALLERY : Uri.parse(state.getString(FILE)));
  }

  private void open(Scene scene) {
    startActivity(RenderActivity.intent(this, file, scene.name()));
  }

  private void read(Uri next) {
    if (file != null) {
      thumbnails.close();
      thumbnails = new Thumbnails(new ThumbnailCache(this));
    }
    file = next;
    message.setText(R.string.reading);
    message.setVisibility(View.VISIBLE);
    GlintApplication.library(this).read(next, reading -> show(next, reading));
  }

  private void show(Uri read, Reading reading) {
    if (isDestroyed() || !read.equals(file)) {
      return;
    }
    setTitle(title(reading));
    thumbnails.watch(scenes::notifyDataSetChanged);
    scenes.show(reading, thumbnails);
    int wrong = reading.problems().size();
    message.setText(
        getResources().getQuantityString(R.plurals.problems, wrong, wrong)
            + "\n"
            + TextUtils.join("\n", reading.problems()));
    message.setVisibility(wrong > 0 ? View.VISIBLE : View.GONE);
  }

  private String title(Reading reading) {
    if (SceneReader.GALLERY.equals(file)) {
      return getString(R.string.app_name);
    }
    return SceneReader.STORIES.equals(file) ? getString(R.string.stories) : reading.name();
  }

  @Override
  public boolean onCreateOptionsMenu(Menu menu) {
    getMenuInflater().inflate(R.menu.main, menu);
    return true;
  }

  @Override
  public boolean onOptionsItemSelected(MenuItem item) {
    if (item.getItemId() == R.id.open) {
      pick();
    } else if (item.getItemId() == R.id.gallery) {
      read(SceneReader.GALLERY);
    } else if (item.getItemId() == R.id.stories) {
      read(SceneReader.STORIES);
    } else if (item.getItemId() == R.id.settings) {
      startActivity(new Intent(this, SettingsActivity.class));
    } else {
      return super.onOptionsItemSelected(item);
    }
    return true;
  }

  /** Lets a person pick a document; none of the kinds of scene files has a media type. */
  private void pick() {
    Intent pick = new Intent(Intent.ACTION_OPEN_DOCUMENT).setType("*/*");
    try {
      startActivityForResult(pick.addCategory(Intent.CATEGORY_OPENABLE), PICK);
    } catch (ActivityNotFoundException e) {
      Toast.makeText(this, R.string.nothing_to_open_with, Toast.LENGTH_LONG).show();
    }
  }

  @Override
  protected void onActivityResult(int request, int result, Intent data) {
    super.onActivityResult(request, result, data);
    if (result == RESULT_OK && data != null && data.getData() != null) {
      keepAccess(data);
      read(data.getData());
    }
  }

  /**
   * Keeps the right to read a document, where its provider grants that, for when the app is
   * restored.
   */
  private void keepAccess(Intent data) {
    try {
      getContentResolver()
          .takePersistableUriPermission(data.getData(), Intent.FLAG_GRANT_READ_URI_PERMISSION);
    } catch (SecurityException e) {
      // it can be read as long as the app is not ended
    }
  }

  @Override
  protected void onSaveInstanceState(Bundle state) {
    super.onSaveInstanceState(state);
    state.putString(FILE, file.toString());
  }

  @Override
  public Object onRetainNonConfigurationInstance() {
    return thumbnails;
  }

  @Override
  protected void onStart() {
    super.onStart();
    thumbnails.hold(false);
  }

  @Override
  protected void onStop() {
    super.onStop();
    thumbnails.hold(true);
  }

  @Override
  protected void onDestroy() {
    super.onDestroy();
    thumbnails.watch(() -> {});
    if (!isChangingConfigurations()) {
      thumbnails.close();
    }
  }

  @Override
  public void onTrimMemory(int level) {
    super.onTrimMemory(level);
    if (level >= TRIM_MEMORY_BACKGROUND) {
      thumbnails.forget();
    }
  }
}

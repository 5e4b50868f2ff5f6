package glint.android;

import android.app.Activity;
import android.os.Bundle;
import android.widget.ArrayAdapter;
import android.widget.ListView;
import glint.io.SceneFile;
import glint.scene.Scene;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Lists the scenes of the gallery. */
public final class MainActivity extends Activity {

  private static final String GALLERY = "gallery.yaml";

  @Override
  protected void onCreate(Bundle savedInstanceState) {
    super.onCreate(savedInstanceState);
    List<String> titles = new ArrayList<>();
    try {
      SceneFile gallery = new SceneAssets(getAssets()).read(GALLERY);
      for (Scene scene : gallery.scenes()) {
        titles.add(scene.title().isEmpty() ? scene.name() : scene.title());
      }
    } catch (IOException e) {
      throw new IllegalStateException("the app is packed with its gallery", e);
    }
    ListView list = new ListView(this);
    list.setAdapter(new ArrayAdapter<>(this, android.R.layout.simple_list_item_1, titles));
    setContentView(list);
  }
}

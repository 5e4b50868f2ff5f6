package glint.android;

import android.content.Context;
import android.view.LayoutInflater;
import android.view.View;
import android.view.ViewGroup;
import android.widget.BaseAdapter;
import android.widget.ImageView;
import android.widget.TextView;
import glint.scene.Scene;
import java.util.List;

/** The rows of a list of scenes. */
final class SceneAdapter extends BaseAdapter {

  private final Context context;
  private Thumbnails thumbnails;
  private List<Scene> scenes = List.of();
  private String digest;

  SceneAdapter(Context context) {
    this.context = context;
  }

  /** Sets whose scenes are listed, and where their pictures come from. */
  void show(Reading file, Thumbnails newThumbnails) {
    scenes = file.scenes();
    digest = file.digest();
    thumbnails = newThumbnails;
    notifyDataSetChanged();
  }

  @Override
  public int getCount() {
    return scenes.size();
  }

  @Override
  public Scene getItem(int position) {
    return scenes.get(position);
  }

  @Override
  public long getItemId(int position) {
    return position;
  }

  @Override
  public View getView(int position, View old, ViewGroup parent) {
    View row =
        old == null ? LayoutInflater.from(context).inflate(R.layout.scene, parent, false) : old;
    Scene scene = getItem(position);
    ((TextView) row.findViewById(R.id.title)).setText(scene.title());
    String size = context.getString(R.string.size, scene.width(), scene.height());
    ((TextView) row.findViewById(R.id.size)).setText(size);
    ((ImageView) row.findViewById(R.id.thumbnail)).setImageBitmap(thumbnails.of(scene, digest));
    return row;
  }
}

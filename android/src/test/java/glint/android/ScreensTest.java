package glint.android;

import static org.junit.Assert.assertTrue;

import android.app.Activity;
import android.graphics.Bitmap;
import android.graphics.Color;
import android.graphics.drawable.BitmapDrawable;
import android.widget.ImageView;
import android.widget.ListView;
import java.io.IOException;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/** What the screens look like, by day and by night; the pictures are kept for people. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class ScreensTest {

  @Test
  @Config(qualifiers = "w360dp-h640dp-notnight-xhdpi")
  public void light() throws IOException {
    show("light", true);
  }

  @Test
  @Config(qualifiers = "w360dp-h640dp-night-xhdpi")
  public void dark() throws IOException {
    show("dark", false);
  }

  @Test
  @Config(qualifiers = "w640dp-h360dp-land-notnight-xhdpi")
  public void broad() throws IOException {
    render("broad", true);
  }

  private static void show(String name, boolean light) throws IOException {
    list(name, light);
    render(name, light);
    try (ActivityController<SettingsActivity> settings =
        Robolectric.buildActivity(SettingsActivity.class)) {
      keep(settings.setup().get(), "settings-" + name, light);
    }
  }

  private static void list(String name, boolean light) throws IOException {
    try (ActivityController<MainActivity> main = Robolectric.buildActivity(MainActivity.class)) {
      MainActivity list = main.setup().get();
      ListView scenes = list.findViewById(R.id.scenes);
      Waiting.until("the gallery is read", () -> scenes.getChildCount() > 0);
      Waiting.until("the list has pictures", () -> pictures(scenes) == scenes.getChildCount());
      keep(list, "list-" + name, light);
    }
  }

  private static int pictures(ListView scenes) {
    int count = 0;
    for (int i = 0; i < scenes.getChildCount(); i++) {
      ImageView thumbnail = scenes.getChildAt(i).findViewById(R.id.thumbnail);
      count += ((BitmapDrawable) thumbnail.getDrawable()).getBitmap() == null ? 0 : 1;
    }
    return count;
  }

  private static void render(String name, boolean light) throws IOException {
    try (ActivityController<RenderActivity> controller =
        Screens.open(SceneReader.GALLERY, "checkmate", new Settings(1, 2, Settings.Size.W640))) {
      RenderActivity screen = controller.get();
      PictureView picture = screen.findViewById(R.id.picture);
      Waiting.until("a first picture", () -> picture.bitmap() != null);
      keep(screen, "rendering-" + name, light);
      Waiting.until("it is over", () -> screen.session().status().state().isOver());
      keep(screen, "finished-" + name, light);
    }
  }

  /** Keeps the picture of a screen, which is light or dark in its corner above the navigation. */
  private static void keep(Activity activity, String name, boolean light) throws IOException {
    Bitmap screen = Screen.of(activity);
    Screen.write(screen, name);
    float luminance =
        Color.luminance(screen.getPixel(screen.getWidth() - 3, screen.getHeight() - 3));
    assertTrue(name + " " + luminance, light ? luminance > 0.8 : luminance < 0.1);
  }
}

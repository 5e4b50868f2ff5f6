package glint.android;

import static org.junit.Assert.assertEquals;
import static org.robolectric.Shadows.shadowOf;

import android.content.Intent;
import android.widget.ListView;
import glint.android.Status.State;
import glint.scene.Scene;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/** Every scene of the gallery is picked in the list, and its picture is that of the desktop. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class GalleryTest {

  @Test
  public void everyPictureIsThatOfTheDesktop() {
    try (ActivityController<MainActivity> main = Robolectric.buildActivity(MainActivity.class)) {
      MainActivity list = main.setup().get();
      new Settings(4, 2, Settings.Size.W160).save(list);
      ListView scenes = list.findViewById(R.id.scenes);
      Waiting.until("the gallery is read", () -> scenes.getCount() > 0);
      assertEquals(Desktop.images(), scenes.getCount());
      main.pause().stop();
      for (int i = 0; i < scenes.getCount(); i++) {
        scenes.performItemClick(null, i, i);
        Scene scene = (Scene) scenes.getItemAtPosition(i);
        equalsDesktop(scene.name(), shadowOf(list).getNextStartedActivity());
      }
    }
  }

  private static void equalsDesktop(String name, Intent intent) {
    try (ActivityController<RenderActivity> controller =
        Robolectric.buildActivity(RenderActivity.class, intent)) {
      RenderActivity screen = controller.setup().get();
      Waiting.until("the scene is read", () -> screen.session() != null);
      Waiting.until(name + " is done", () -> screen.session().status().state().isOver());
      assertEquals(State.DONE, screen.session().status().state());
      PictureView picture = screen.findViewById(R.id.picture);
      Desktop.assertSame(name, picture.bitmap());
    }
  }
}

package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.widget.Spinner;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/** What is chosen in the settings is kept, and is what renders do. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class SettingsTest {

  private final Context context = RuntimeEnvironment.getApplication();

  @Test
  public void theyBeginWithDefaults() {
    assertEquals(
        new Settings(1, Settings.mostThreads(), Settings.Size.SCENE), Settings.load(context));
  }

  @Test
  public void whatIsChosenIsKept() {
    try (ActivityController<SettingsActivity> controller =
        Robolectric.buildActivity(SettingsActivity.class)) {
      SettingsActivity screen = controller.setup().get();
      select(screen, R.id.levels, "0.5");
      select(screen, R.id.threads, "1 thread");
      select(screen, R.id.size, "320 × 240");
      controller.pause();
    }
    assertEquals(new Settings(0.5f, 1, Settings.Size.W320), Settings.load(context));
    try (ActivityController<SettingsActivity> controller =
        Robolectric.buildActivity(SettingsActivity.class)) {
      Spinner levels = controller.setup().get().findViewById(R.id.levels);
      assertEquals("0.5", levels.getSelectedItem());
    }
  }

  private static void select(SettingsActivity screen, int id, String words) {
    Spinner spinner = screen.findViewById(id);
    for (int i = 0; i < spinner.getCount(); i++) {
      if (spinner.getItemAtPosition(i).equals(words)) {
        spinner.setSelection(i);
        return;
      }
    }
    throw new AssertionError("no " + words);
  }

  @Test
  public void rendersAreAsChosen() {
    Settings chosen = new Settings(0.5f, 1, Settings.Size.W320);
    try (ActivityController<RenderActivity> controller =
        Screens.open(SceneReader.GALLERY, "cornell-box", chosen)) {
      Session session = controller.get().session();
      Waiting.until("it is over", () -> session.status().state().isOver());
      assertEquals(320, session.bitmap().getWidth());
      assertEquals(240, session.bitmap().getHeight());
      double reached = session.status().error();
      assertTrue("error " + reached, reached > 0 && reached <= 0.5);
    }
  }
}

package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.app.Activity;
import android.app.AlertDialog;
import android.view.View;
import android.view.ViewGroup;
import android.widget.AdapterView;
import android.widget.ListView;
import android.widget.ProgressBar;
import android.widget.Spinner;
import android.widget.TextView;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.fakes.RoboMenuItem;
import org.robolectric.shadows.ShadowDialog;

/** A screen reader can name whatever can be used, and tells how a render comes along. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class LabelsTest {

  /** Returns the views of a screen that have something to say or to do, but no words. */
  private static List<String> nameless(Activity activity) {
    List<String> found = new ArrayList<>();
    collect(activity.getWindow().getDecorView(), activity, found);
    return found;
  }

  private static void collect(View view, Activity activity, List<String> found) {
    boolean tells =
        view.isClickable() || view instanceof PictureView || view instanceof ProgressBar;
    boolean named =
        view.getContentDescription() != null
            || (view instanceof TextView && ((TextView) view).getText().length() > 0)
            || label(view, activity.getWindow().getDecorView())
            || view instanceof ListView;
    if (tells && !named && view.getVisibility() == View.VISIBLE) {
      found.add(view.toString());
    }
    if (view instanceof ViewGroup && !(view instanceof Spinner)) {
      ViewGroup group = (ViewGroup) view;
      for (int i = 0; i < group.getChildCount(); i++) {
        collect(group.getChildAt(i), activity, found);
      }
    }
  }

  /** Returns whether another view is the label of one. */
  private static boolean label(View view, View root) {
    if (view.getId() != View.NO_ID && root.getLabelFor() == view.getId()) {
      return true;
    }
    if (root instanceof ViewGroup) {
      for (int i = 0; i < ((ViewGroup) root).getChildCount(); i++) {
        if (label(view, ((ViewGroup) root).getChildAt(i))) {
          return true;
        }
      }
    }
    return false;
  }

  @Test
  public void everythingHasWords() {
    try (ActivityController<MainActivity> main = Robolectric.buildActivity(MainActivity.class)) {
      MainActivity list = main.setup().get();
      AdapterView<?> scenes = list.findViewById(R.id.scenes);
      Waiting.until("the gallery is read", () -> scenes.getChildCount() > 0);
      assertEquals(List.of(), nameless(list));
    }
    try (ActivityController<SettingsActivity> settings =
        Robolectric.buildActivity(SettingsActivity.class)) {
      assertEquals(List.of(), nameless(settings.setup().get()));
    }
  }

  @Test
  public void aRenderIsToldOf() {
    try (ActivityController<RenderActivity> controller =
        Screens.open(SceneReader.GALLERY, "stones", new Settings(4, 2, Settings.Size.W160))) {
      RenderActivity screen = controller.get();
      assertEquals(List.of(), nameless(screen));
      assertEquals(
          "Picture of: Pebbles balanced on still water",
          screen.findViewById(R.id.picture).getContentDescription());
      assertEquals(
          View.ACCESSIBILITY_LIVE_REGION_POLITE,
          screen.findViewById(R.id.state).getAccessibilityLiveRegion());
      assertEquals(
          View.ACCESSIBILITY_LIVE_REGION_NONE,
          screen.findViewById(R.id.figures).getAccessibilityLiveRegion());
      assertEquals("Pebbles balanced on still water", screen.getTitle().toString());
    }
  }

  @Test
  public void whatIsLeftOutIsTold() {
    try (ActivityController<RenderActivity> controller =
        Screens.open(SceneReader.GALLERY, "stones", new Settings(4, 2, Settings.Size.W160))) {
      RenderActivity screen = controller.get();
      Waiting.until("it is prepared", () -> !screen.session().plan().isEmpty());
      screen.onOptionsItemSelected(new RoboMenuItem(R.id.plan));
      ListView lines = ((AlertDialog) ShadowDialog.getLatestDialog()).getListView();
      assertEquals(screen.session().plan().size(), lines.getCount());
      assertTrue(
          lines.getItemAtPosition(0).toString(),
          lines.getItemAtPosition(0).toString().startsWith("Left out: lens ("));
    }
  }
}

package glint.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.robolectric.Shadows.shadowOf;

import android.Manifest;
import android.content.pm.PackageManager;
import android.net.Uri;
import android.provider.MediaStore.Images.Media;
import java.io.ByteArrayOutputStream;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.fakes.RoboMenuItem;
import org.robolectric.shadows.ShadowToast;

/**
 * The oldest Android that the app runs on: the picture is the same, and to save it is asked for.
 */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 26)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class OldestTest {

  @Test
  public void rendersAndSaves() {
    FakeMedia media = Robolectric.buildContentProvider(FakeMedia.class).create("media").get();
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    shadowOf(RuntimeEnvironment.getApplication().getContentResolver())
        .registerOutputStream(Uri.parse("content://media/external/images/media/1"), written);
    try (ActivityController<RenderActivity> controller =
        Screens.open(
            SceneReader.GALLERY, "globe-on-crates", new Settings(4, 2, Settings.Size.W160))) {
      RenderActivity screen = controller.get();
      Waiting.until("it is over", () -> screen.session().status().state().isOver());
      Desktop.assertSame("globe-on-crates", screen.session().bitmap());

      screen.onOptionsItemSelected(new RoboMenuItem(R.id.save));
      assertArrayEquals(
          new String[] {Manifest.permission.WRITE_EXTERNAL_STORAGE},
          shadowOf(screen).getLastRequestedPermission().requestedPermissions);
      answer(screen, PackageManager.PERMISSION_DENIED);
      assertEquals("Not saved: Glint may not write pictures.", ShadowToast.getTextOfLatestToast());
      assertEquals(0, written.size());

      shadowOf(RuntimeEnvironment.getApplication())
          .grantPermissions(Manifest.permission.WRITE_EXTERNAL_STORAGE);
      answer(screen, PackageManager.PERMISSION_GRANTED);
      Waiting.until("it says so", () -> ShadowToast.shownToastCount() == 2);
      assertEquals("Saved to your pictures", ShadowToast.getTextOfLatestToast());
      assertNull(media.said.get(Media.RELATIVE_PATH));
    }
  }

  private static void answer(RenderActivity screen, int result) {
    int request = shadowOf(screen).getLastRequestedPermission().requestCode;
    screen.onRequestPermissionsResult(
        request, new String[] {Manifest.permission.WRITE_EXTERNAL_STORAGE}, new int[] {result});
  }
}

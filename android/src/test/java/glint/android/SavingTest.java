package glint.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.robolectric.Shadows.shadowOf;

import android.content.Intent;
import android.graphics.BitmapFactory;
import android.net.Uri;
import android.provider.MediaStore.Images.Media;
import java.io.ByteArrayOutputStream;
import org.junit.After;
import org.junit.Before;
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

/** A finished picture goes to the device's pictures, and from there to other apps. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class SavingTest {

  private static final String SCENE = "globe-on-crates";

  private static final Uri PICTURE = Uri.parse("content://media/external/images/media/1");

  private final ByteArrayOutputStream written = new ByteArrayOutputStream();
  private FakeMedia media;
  private ActivityController<RenderActivity> controller;
  private RenderActivity screen;

  @Before
  public void open() {
    media = Robolectric.buildContentProvider(FakeMedia.class).create("media").get();
    Settings small = new Settings(4, 2, Settings.Size.W160);
    shadowOf(RuntimeEnvironment.getApplication().getContentResolver())
        .registerOutputStream(PICTURE, written);
    controller = Screens.open(SceneReader.GALLERY, SCENE, small);
    screen = controller.get();
    Waiting.until("it is over", () -> screen.session().status().state().isOver());
  }

  @After
  public void close() {
    controller.close();
  }

  private void choose(int command) {
    screen.onOptionsItemSelected(new RoboMenuItem(command));
  }

  @Test
  public void whatIsSavedIsThePicture() {
    choose(R.id.save);
    Waiting.until("it says so", () -> ShadowToast.shownToastCount() > 0);
    assertEquals("Saved to your pictures", ShadowToast.getTextOfLatestToast());
    assertArrayEquals(
        Desktop.pixels(screen.session().bitmap()),
        Desktop.pixels(BitmapFactory.decodeByteArray(written.toByteArray(), 0, written.size())));
    assertEquals(SCENE + ".png", media.said.getAsString(Media.DISPLAY_NAME));
    assertEquals("image/png", media.said.getAsString(Media.MIME_TYPE));
    assertEquals("Pictures/Glint", media.said.getAsString(Media.RELATIVE_PATH));
    assertEquals(Integer.valueOf(0), media.said.getAsInteger(Media.IS_PENDING));
  }

  @Test
  public void whatIsSharedIsThePictureSaved() {
    choose(R.id.share);
    Intent[] chooser = new Intent[1];
    Waiting.until(
        "apps are offered", () -> (chooser[0] = shadowOf(screen).getNextStartedActivity()) != null);
    Intent send = chooser[0].getParcelableExtra(Intent.EXTRA_INTENT, Intent.class);
    assertEquals(Intent.ACTION_SEND, send.getAction());
    assertEquals("image/png", send.getType());
    assertEquals(PICTURE, send.getParcelableExtra(Intent.EXTRA_STREAM, Uri.class));
    assertEquals(
        Intent.FLAG_GRANT_READ_URI_PERMISSION,
        send.getFlags() & Intent.FLAG_GRANT_READ_URI_PERMISSION);
  }

  @Test
  public void aStoreThatTakesNothingIsToldOf() {
    media.full = true;
    choose(R.id.save);
    Waiting.until("it says so", () -> ShadowToast.shownToastCount() > 0);
    assertEquals("Not saved: Pictures/Glint", ShadowToast.getTextOfLatestToast());
  }
}

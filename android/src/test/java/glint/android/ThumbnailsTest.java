package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.content.Context;
import android.graphics.Bitmap;
import android.graphics.Color;
import android.graphics.drawable.BitmapDrawable;
import android.net.Uri;
import android.os.Bundle;
import android.widget.ImageView;
import android.widget.ListView;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.StandardCopyOption;
import java.util.List;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/** The small pictures of a list are rendered once, not whenever the app is started. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class ThumbnailsTest {

  private static final Uri FILE = Uri.parse("content://documents/ball.yaml");

  private static final String RED_BALL =
      """
      scenes:
        ball:
          image: {width: 40, height: 30}
          camera: {position: [0, 0, 6], look_at: [0, 0, 0], fov: 35}
          lights:
            - ambient: {color: 1}
          surfaces:
            - sphere: {center: [0, 0, 0], radius: 1, material: {color: "#ff0000"}}
      """;

  private final Context context = RuntimeEnvironment.getApplication();
  private final ThumbnailCache cache = new ThumbnailCache(context);

  /** Starts the app with a file that holds a text; returns the middle of the only picture. */
  private int middle(String text) {
    shadowOf(context.getContentResolver())
        .registerInputStreamSupplier(
            FILE, () -> new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    GlintApplication.library(context).forget();
    Bundle state = new Bundle();
    state.putString("file", FILE.toString());
    try (ActivityController<MainActivity> main = Robolectric.buildActivity(MainActivity.class)) {
      ListView scenes = main.setup(state).get().findViewById(R.id.scenes);
      Waiting.until("there is a picture", () -> picture(scenes) != null);
      Bitmap picture = picture(scenes);
      return picture.getPixel(picture.getWidth() / 2, picture.getHeight() / 2);
    }
  }

  private static Bitmap picture(ListView scenes) {
    if (scenes.getChildCount() == 0) {
      return null;
    }
    ImageView thumbnail = scenes.getChildAt(0).findViewById(R.id.thumbnail);
    return ((BitmapDrawable) thumbnail.getDrawable()).getBitmap();
  }

  private File[] kept() {
    File[] files = new File(context.getCacheDir(), "thumbnails").listFiles();
    return files == null ? new File[0] : files;
  }

  @Test
  public void theyAreKeptUntilTheFileHoldsSomethingElse() throws IOException {
    assertEquals(Color.RED, middle(RED_BALL));
    assertEquals(1, kept().length);
    File file = kept()[0];
    cache.write("other", "ball", filled(Color.BLUE));
    File blue = kept()[kept()[0].equals(file) ? 1 : 0];
    Files.copy(blue.toPath(), file.toPath(), StandardCopyOption.REPLACE_EXISTING);
    assertEquals("not rendered again", Color.BLUE, middle(RED_BALL));
    assertEquals(Color.RED, middle(RED_BALL + "# another file\n"));
    Files.write(file.toPath(), new byte[] {1, 2, 3});
    assertEquals("broken, and made again", Color.RED, middle(RED_BALL));
  }

  private static Bitmap filled(int color) {
    Bitmap bitmap = Bitmap.createBitmap(4, 3, Bitmap.Config.ARGB_8888);
    bitmap.eraseColor(color);
    return bitmap;
  }

  @Test
  public void eachHasAFileAndASceneAndTheOldestGo() throws IOException {
    cache.write("file", "one", filled(Color.RED));
    cache.write("file", "two", filled(Color.BLUE));
    assertEquals(Color.RED, cache.read("file", "one").getPixel(0, 0));
    assertEquals(Color.BLUE, cache.read("file", "two").getPixel(0, 0));
    assertNull(cache.read("other", "one"));
    for (int i = 0; i < 499; i++) {
      File old = new File(kept()[0].getParentFile(), i + ".png");
      assertTrue(old.createNewFile() && old.setLastModified(1000));
    }
    cache.write("file", "three", filled(Color.GREEN));
    assertEquals(500, kept().length);
    for (String scene : List.of("one", "two", "three")) {
      assertNotNull(scene, cache.read("file", scene));
    }
  }
}

package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.robolectric.Shadows.shadowOf;

import android.app.Activity;
import android.content.Intent;
import android.net.Uri;
import android.view.View;
import android.widget.ListView;
import android.widget.TextView;
import glint.android.Status.State;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;
import org.robolectric.fakes.RoboMenuItem;
import org.robolectric.shadows.ShadowActivity.IntentForResult;

/** Scene files that a person picks with the system's picker. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class DocumentTest {

  private static final Uri FILE = Uri.parse("content://documents/ball.yaml");

  private static final String BALL =
      """
      scenes:
        ball:
          image: {width: 20000, height: 10000}
          camera: {position: [0, 0, 6], look_at: [0, 0, 0], fov: 35}
          lights:
            - ambient: {color: 1}
          surfaces:
            - sphere: {center: [0, 0, 0], radius: 1, material: {color: "#c04030"}}
      """;

  private final ActivityController<MainActivity> main =
      Robolectric.buildActivity(MainActivity.class);
  private MainActivity list;

  @Before
  public void open() {
    list = main.setup().get();
    ListView scenes = list.findViewById(R.id.scenes);
    Waiting.until("the gallery is read", () -> scenes.getCount() == Desktop.images());
  }

  @After
  public void close() {
    main.close();
  }

  /** Picks a file that holds a text. */
  private void pick(String text) {
    list.onOptionsItemSelected(new RoboMenuItem(R.id.open));
    IntentForResult asked = shadowOf(list).getNextStartedActivityForResult();
    assertEquals(Intent.ACTION_OPEN_DOCUMENT, asked.intent.getAction());
    shadowOf(list.getContentResolver())
        .registerInputStreamSupplier(
            FILE, () -> new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    shadowOf(list).receiveResult(asked.intent, Activity.RESULT_OK, new Intent().setData(FILE));
  }

  private String message() {
    TextView message = list.findViewById(R.id.message);
    Waiting.until("it is read", () -> !message.getText().toString().startsWith("Reading"));
    return message.getVisibility() == View.VISIBLE ? message.getText().toString() : "";
  }

  @Test
  public void theStoriesArePackedToo() {
    list.onOptionsItemSelected(new RoboMenuItem(R.id.stories));
    assertEquals("", message());
    ListView scenes = list.findViewById(R.id.scenes);
    assertEquals(3, scenes.getCount());
    assertEquals("Stories", list.getTitle().toString());
    list.onOptionsItemSelected(new RoboMenuItem(R.id.gallery));
    assertEquals("", message());
    assertEquals(Desktop.images(), scenes.getCount());
    assertEquals("Glint", list.getTitle().toString());
  }

  @Test
  public void itsScenesAreListed() {
    pick(BALL);
    assertEquals("", message());
    ListView scenes = list.findViewById(R.id.scenes);
    assertEquals(1, scenes.getCount());
    assertEquals("ball.yaml", list.getTitle().toString());
  }

  @Test
  public void mistakesAreToldWithTheirPlaces() {
    pick(BALL.replace("radius: 1", "radios: 1"));
    String message = message();
    assertTrue(message, message.startsWith("1 problem\nball.yaml:8:"));
    assertTrue(message, message.contains("did you mean 'radius'?"));
  }

  @Test
  public void whatLiesBesideItCannotBeRead() {
    pick(BALL.replace("sphere: {center: [0, 0, 0], radius: 1, ", "mesh: {file: a.obj, "));
    String message = message();
    assertTrue(message, message.contains("the app may read the picked file alone"));
  }

  @Test
  public void aPictureThatDoesNotFitIsMadeSmaller() {
    pick(BALL);
    assertEquals("", message());
    Settings asTheSceneSays = new Settings(8, 2, Settings.Size.SCENE);
    try (ActivityController<RenderActivity> controller =
        Screens.open(FILE, "ball", asTheSceneSays)) {
      RenderActivity screen = controller.get();
      assertTrue(screen.session().isShrunk());
      assertTrue(screen.session().width() < 20000);
      assertTrue(screen.session().width() > 400);
      TextView note = screen.findViewById(R.id.note);
      Waiting.until("it says so", () -> note.getText().toString().startsWith("Memory is short"));
      assertTrue(screen.session().status().state() != State.OUT_OF_MEMORY);
    }
  }
}

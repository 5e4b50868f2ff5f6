package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.view.LayoutInflater;
import android.view.View;
import android.widget.TextView;
import glint.android.Status.State;
import glint.geometry.Mesh;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Camera;
import glint.scene.Orthographic;
import glint.scene.Placement;
import glint.scene.Scene;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.annotation.GraphicsMode;

/** What fits into memory, how much smaller a picture must be, and what is refused. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
public final class HeapTest {

  private static final int MIB = 1 << 20;

  /** Returns a scene of so many triangles, all in one place. */
  private static Scene scene(int triangles) {
    int[] corners = new int[3 * triangles];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = i % 3;
    }
    Mesh mesh = new Mesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, corners);
    Vector3d eye = new Vector3d(0, 0, 1);
    Vector3d up = new Vector3d(0, 1, 0);
    return new Scene.Builder("triangles")
        .camera(Camera.of(eye, Vector3d.ZERO, up, new Orthographic(2)))
        .place(Placement.of(mesh, Material.WHITE))
        .build();
  }

  @Test
  public void picturesAreHalvedUntilTheyFit() {
    Scene scene = scene(1);
    Heap heap = new Heap(10 * MIB);
    assertEquals(0, heap.halvings(scene, 200, 200));
    assertEquals(2, heap.halvings(scene, 1000, 1000));
    assertTrue(heap.holds(scene, 250, 250));
    assertFalse(heap.holds(scene, 1000, 1000));
    assertEquals(0, new Heap(0).halvings(scene, 100, 1000));
  }

  @Test
  public void aSceneThatCannotFitIsRefusedBeforeItFails() {
    Context context = RuntimeEnvironment.getApplication();
    Scene scene = scene(4_000_000);
    Session session = new Session(scene, scene.camera(), new Settings(4, 1, Settings.Size.W160));
    Waiting.until("it is over", () -> session.status().state().isOver());
    assertEquals(State.REFUSED, session.status().state());
    View screen = LayoutInflater.from(context).inflate(R.layout.status, null);
    new StatusPanel(screen).show(session);
    TextView state = screen.findViewById(R.id.state);
    String words = state.getText().toString();
    assertTrue(
        words,
        words.matches("Failed: the scene needs about [0-9]+ MiB .* only [0-9]+ MiB are free"));
    session.close();
  }
}

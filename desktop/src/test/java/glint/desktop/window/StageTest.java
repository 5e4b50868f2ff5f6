package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.desktop.window.Snapshot.State;
import glint.geometry.Sphere;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.nio.file.Path;
import java.util.Deque;
import java.util.concurrent.ConcurrentLinkedDeque;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StageTest {

  private final Deque<Snapshot> heard = new ConcurrentLinkedDeque<>();
  private Picked picked;
  private Stage stage;

  @BeforeEach
  void open() throws Exception {
    Vector3d eye = new Vector3d(0, 0, 9);
    Vector3d up = new Vector3d(0, 1, 0);
    Scene scene =
        new Scene.Builder("ball")
            .size(61, 40)
            .camera(Camera.of(eye, Vector3d.ZERO, up, Projection.vertical(40)))
            .place(Placement.of(new Sphere(Vector3d.ZERO, 2), Material.WHITE))
            .build();
    picked = new Picked(Path.of("a.yaml"), "", scene);
    stage = new Stage(heard::add);
    SwingUtilities.invokeAndWait(() -> stage.show(picked));
  }

  @AfterEach
  void close() throws Exception {
    SwingUtilities.invokeAndWait(stage::end);
  }

  private State awaitOver() throws InterruptedException {
    while (heard.isEmpty() || !heard.getLast().state().isOver()) {
      Thread.sleep(5);
    }
    return heard.getLast().state();
  }

  @Test
  void aCameraThatIsStoppedOnItsWayIsNotRendered() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          stage.move(held -> held.rolled(5));
          stage.stop();
        });
    assertEquals(State.STOPPED, awaitOver());
    assertTrue(heard.getLast().picture().isPresent());
    heard.clear();
    SwingUtilities.invokeAndWait(stage::rest);
    Thread.sleep(300);
    assertEquals(0, heard.size());
    SwingUtilities.invokeAndWait(() -> stage.move(held -> held.rolled(5)));
    assertEquals(State.DONE, awaitOver());
  }

  @Test
  void anotherSceneIsRenderedThoughTheCameraWasStopped() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          stage.move(held -> held.rolled(5));
          stage.stop();
          stage.show(picked);
        });
    assertEquals(State.DONE, awaitOver());
  }
}

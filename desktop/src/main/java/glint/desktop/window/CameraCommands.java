package glint.desktop.window;

import glint.io.CameraText;
import glint.scene.Camera;
import glint.scene.Handheld;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.function.Function;

/** What the keyboard does with the camera. */
final class CameraCommands {

  /** A step about the target, as a way on the ball of radius 1: five degrees, which turn by ten. */
  private static final double STEP = StrictMath.sin(StrictMath.toRadians(5));

  /** A step across, in heights of the picture. */
  private static final double ACROSS = 0.1;

  private static final double ROLL = 5;
  private static final double NEARER = 1 / 1.1;

  private final Stage stage;
  private final Notice notice;

  /** Makes the commands for the camera of a stage. */
  CameraCommands(Stage stage, Notice notice) {
    this.stage = stage;
    this.notice = notice;
  }

  /** Adds a menu. */
  void add(Controls controls) {
    controls.menu("Camera");
    add(controls, "Orbit left", "J", held -> orbited(held, 1, 0));
    add(controls, "Orbit right", "L", held -> orbited(held, -1, 0));
    add(controls, "Orbit up", "I", held -> orbited(held, 0, 1));
    add(controls, "Orbit down", "K", held -> orbited(held, 0, -1));
    add(controls, "Left", "shift J", held -> panned(held, 1, 0));
    add(controls, "Right", "shift L", held -> panned(held, -1, 0));
    add(controls, "Up", "shift I", held -> panned(held, 0, 1));
    add(controls, "Down", "shift K", held -> panned(held, 0, -1));
    add(controls, "Nearer", "PAGE_UP", held -> held.dollied(NEARER));
    add(controls, "Farther", "PAGE_DOWN", held -> held.dollied(1 / NEARER));
    add(controls, "Roll left", "COMMA", held -> held.rolled(-ROLL));
    add(controls, "Roll right", "PERIOD", held -> held.rolled(ROLL));
    controls.gap();
    controls.item("Target in the middle", "T", this::aimAtMiddle);
    controls.add("Reset camera", "R", stage::reset);
    controls.item("Copy camera as YAML", "Y", this::copy);
  }

  private void add(Controls controls, String text, String key, Function<Handheld, Camera> move) {
    controls.item(text, key, () -> stage.move(move));
  }

  private static Camera orbited(Handheld held, int right, int down) {
    double x = held.width() / 2.0;
    double y = held.height() / 2.0;
    double way = STEP * Math.min(x, y);
    return held.orbited(x, y, x + way * right, y + way * down);
  }

  private static Camera panned(Handheld held, int right, int down) {
    double way = ACROSS * held.height();
    return held.panned(way * right, way * down);
  }

  private void aimAtMiddle() {
    if (stage.camera().isPresent()) {
      stage.aim(new Point(stage.held().width() / 2, stage.held().height() / 2));
    }
  }

  private void copy() {
    if (stage.camera().isPresent()) {
      StringSelection text = new StringSelection(CameraText.of(stage.camera().get()));
      Toolkit.getDefaultToolkit().getSystemClipboard().setContents(text, null);
      notice.say("the camera is in the clipboard, as YAML");
    }
  }
}

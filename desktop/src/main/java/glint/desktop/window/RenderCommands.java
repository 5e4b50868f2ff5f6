package glint.desktop.window;

import glint.desktop.window.Snapshot.State;
import javax.swing.Action;

/** What menus and keys do with the render itself. */
final class RenderCommands {

  private final Stage stage;
  private final Runnable measure;
  private Action pause;
  private Action stop;
  private boolean paused;

  /**
   * Makes the commands for the render of a stage.
   *
   * @param measure measures speed against error, or ends that
   */
  RenderCommands(Stage stage, Runnable measure) {
    this.stage = stage;
    this.measure = measure;
  }

  /** Adds a menu. */
  void add(Controls controls) {
    controls.menu("Render");
    pause = controls.add("Pause", "SPACE", () -> stage.pause(!paused)).getAction();
    stop = controls.add("Stop", "ESCAPE", stage::stop).getAction();
    controls.item("Measure speed", "M", measure);
  }

  /** Offers what can be done now. */
  void show(State state) {
    paused = state == State.PAUSED;
    pause.putValue(Action.NAME, paused ? "Continue" : "Pause");
    pause.setEnabled(!state.isOver());
    stop.setEnabled(!state.isOver());
  }
}

package glint.desktop.window;

import java.awt.Point;
import javax.swing.JTabbedPane;
import javax.swing.Timer;

/** Looks into a pixel: its rays in the side panel, and their way drawn over the picture. */
final class RayInspector {

  /** A second click within this time means something else than the first. */
  private static final int CLICK_MILLIS = 250;

  private final Stage stage;
  private final PictureView view;
  private final JTabbedPane side;
  private final RayPath path = new RayPath();
  private final RayPanel panel = new RayPanel(this::choose);
  private final Timer soon = new Timer(CLICK_MILLIS, e -> look());
  private Point pixel;

  /** Adds a tab to the side panel, and a path to what is drawn over the picture. */
  RayInspector(Stage stage, PictureView view, JTabbedPane side) {
    this.stage = stage;
    this.view = view;
    this.side = side;
    soon.setRepeats(false);
    view.add(path);
    side.addTab("Rays", panel);
  }

  /** Adds commands for the pixel. */
  void add(Controls controls) {
    controls.item("Rays of the pixel", "Q", () -> inspect(pixelOrMiddle()));
    controls.item("Pixel to the left", "alt LEFT", () -> step(-1, 0));
    controls.item("Pixel to the right", "alt RIGHT", () -> step(1, 0));
    controls.item("Pixel above", "alt UP", () -> step(0, -1));
    controls.item("Pixel below", "alt DOWN", () -> step(0, 1));
  }

  /** Shows the rays of a pixel that was clicked on, unless it is clicked on again. */
  void clicked(Point at) {
    pixel = at;
    soon.restart();
  }

  /** Makes a pixel that was clicked on twice the camera's target. */
  void doubleClicked(Point at) {
    soon.stop();
    stage.aim(at);
  }

  /** Forgets the pixel: the picture is another one. */
  void clear() {
    soon.stop();
    pixel = null;
    path.clear();
    panel.clear();
    view.repaint();
  }

  private Point pixelOrMiddle() {
    boolean none = pixel == null && stage.camera().isPresent();
    return none ? new Point(stage.held().width() / 2, stage.held().height() / 2) : pixel;
  }

  private void step(int columns, int rows) {
    Point from = pixelOrMiddle();
    if (from != null) {
      int x = Math.max(0, Math.min(stage.held().width() - 1, from.x + columns));
      int y = Math.max(0, Math.min(stage.held().height() - 1, from.y + rows));
      inspect(new Point(x, y));
    }
  }

  private void inspect(Point at) {
    pixel = at;
    look();
  }

  private void look() {
    if (pixel == null) {
      return;
    }
    stage.look(
        pixel,
        rays -> {
          if (rays.pixel().equals(pixel)) {
            path.show(rays);
            panel.show(rays);
            side.setSelectedComponent(panel);
            view.repaint();
          }
        });
  }

  private void choose(int ray) {
    path.choose(ray);
    view.repaint();
  }
}

package glint.desktop.window;

import glint.scene.Handheld;
import java.awt.Point;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.event.MouseInputAdapter;

/** The mouse on the picture: moves the camera, or, with the control key, the picture itself. */
final class Hand extends MouseInputAdapter {

  /** By how many times a notch of the wheel brings the camera away. */
  private static final double NOTCH = 1.1;

  /** By how many degrees a notch of the wheel rolls. */
  private static final double ROLL = 5;

  /** A pointer that has moved by fewer units of the view only clicks. */
  private static final int STILL = 3;

  private enum Tool {
    PICTURE,
    ORBIT,
    PAN
  }

  private final PictureView view;
  private final Stage stage;
  private final Consumer<Point> clicked;
  private final Consumer<Point> doubleClicked;
  private Tool tool;
  private Point begin;
  private Point last;
  private Handheld held;
  private boolean moved;

  /**
   * Makes one that moves the camera of a stage.
   *
   * @param clicked hears of a pixel that is clicked on
   * @param doubleClicked hears of a pixel that is clicked on again
   */
  Hand(PictureView view, Stage stage, Consumer<Point> clicked, Consumer<Point> doubleClicked) {
    this.view = view;
    this.stage = stage;
    this.clicked = clicked;
    this.doubleClicked = doubleClicked;
    view.addMouseListener(this);
    view.addMouseMotionListener(this);
    view.addMouseWheelListener(this);
  }

  @Override
  public void mousePressed(MouseEvent e) {
    begin = e.getPoint();
    last = begin;
    moved = false;
    held = stage.camera().isPresent() ? stage.held() : null;
    boolean pans = e.isShiftDown() || !SwingUtilities.isLeftMouseButton(e);
    tool = e.isControlDown() ? Tool.PICTURE : pans ? Tool.PAN : Tool.ORBIT;
  }

  @Override
  public void mouseDragged(MouseEvent e) {
    moved |= begin.distance(e.getPoint()) > STILL;
    if (!moved || held == null || view.zoom() == null) {
      return;
    }
    Zoom zoom = view.zoom();
    double x = zoom.across(e.getX());
    double y = zoom.down(e.getY());
    double fromX = zoom.across(begin.x);
    double fromY = zoom.down(begin.y);
    switch (tool) {
      case PICTURE -> view.shift(e.getX() - last.x, e.getY() - last.y);
      case ORBIT -> stage.move(now -> held.orbited(fromX, fromY, x, y));
      case PAN -> stage.move(now -> held.panned(x - fromX, y - fromY));
    }
    last = e.getPoint();
  }

  @Override
  public void mouseReleased(MouseEvent e) {
    if (moved) {
      stage.rest();
      return;
    }
    Point pixel = view.pixel(e.getPoint());
    if (pixel != null && tool == Tool.ORBIT) {
      (e.getClickCount() == 2 ? doubleClicked : clicked).accept(pixel);
    }
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent e) {
    double notches = e.getPreciseWheelRotation();
    if (e.isControlDown()) {
      view.zoomBy(-notches, e.getX(), e.getY());
    } else if (e.isShiftDown()) {
      stage.move(held -> held.rolled(ROLL * notches));
    } else {
      stage.move(held -> held.dollied(Math.pow(NOTCH, notches)));
    }
  }
}

package glint.desktop.window;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.event.MouseInputAdapter;

/** Shows a picture, larger or smaller: the wheel zooms, dragging moves it. */
final class PictureView extends JComponent {

  private static final long serialVersionUID = 1;

  /** By how much a notch of the wheel zooms. */
  private static final double NOTCH = 1.2;

  private final transient Consumer<Point> pointed;
  private transient BufferedImage picture;
  private transient Zoom zoom;
  private boolean fitted = true;

  /**
   * Makes an empty view.
   *
   * @param pointed hears of the pixel that the pointer is at, or of null
   */
  PictureView(Consumer<Point> pointed) {
    this.pointed = pointed;
    setName("picture");
    setPreferredSize(new Dimension(800, 600));
    Mouse mouse = new Mouse();
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent e) {
            if (fitted) {
              fit();
            }
          }
        });
  }

  /** Shows a picture; one of another size than before is fitted. */
  void show(BufferedImage next) {
    boolean same = picture != null && next != null;
    same = same && picture.getWidth() == next.getWidth();
    same = same && picture.getHeight() == next.getHeight();
    picture = next;
    if (!same) {
      fit();
    }
    repaint();
  }

  /** Returns what is shown, or null. */
  BufferedImage picture() {
    return picture;
  }

  /** Returns how it is shown, or null if nothing is. */
  Zoom zoom() {
    return zoom;
  }

  /** Shows all of the picture, as large as the view allows. */
  void fit() {
    fitted = true;
    if (picture != null) {
      zoom = Zoom.fit(picture.getWidth(), picture.getHeight(), getWidth(), getHeight());
      repaint();
    }
  }

  /** Shows every pixel as one of the display. */
  void oneToOne() {
    if (picture != null) {
      double unit = 1 / getGraphicsConfiguration().getDefaultTransform().getScaleX();
      int width = picture.getWidth();
      change(Zoom.centred(unit, width, picture.getHeight(), getWidth(), getHeight()));
    }
  }

  /** Zooms about the middle of the view, by notches of a wheel. */
  void zoomBy(int notches) {
    zoomBy(notches, getWidth() / 2.0, getHeight() / 2.0);
  }

  private void zoomBy(double notches, double x, double y) {
    if (zoom != null) {
      change(zoom.about(Math.pow(NOTCH, notches), x, y));
    }
  }

  private void change(Zoom next) {
    fitted = false;
    zoom = next;
    repaint();
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    if (accessibleContext == null) {
      accessibleContext = new AccessiblePicture();
      accessibleContext.setAccessibleName("Picture");
    }
    return accessibleContext;
  }

  private final class AccessiblePicture extends AccessibleJComponent {
    private static final long serialVersionUID = 1;

    @Override
    public AccessibleRole getAccessibleRole() {
      return AccessibleRole.CANVAS;
    }
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    if (picture == null) {
      return;
    }
    Graphics2D g = (Graphics2D) graphics.create();
    double device = g.getTransform().getScaleX() * zoom.scale();
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION,
        device < 1
            ? RenderingHints.VALUE_INTERPOLATION_BILINEAR
            : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    AffineTransform place = AffineTransform.getTranslateInstance(zoom.x(), zoom.y());
    place.scale(zoom.scale(), zoom.scale());
    g.drawImage(picture, place, null);
    g.dispose();
  }

  private final class Mouse extends MouseInputAdapter {
    private Point last;

    @Override
    public void mousePressed(MouseEvent e) {
      last = e.getPoint();
    }

    @Override
    public void mouseDragged(MouseEvent e) {
      if (zoom != null && last != null) {
        change(zoom.moved(e.getX() - last.x, e.getY() - last.y));
        last = e.getPoint();
      }
    }

    @Override
    public void mouseMoved(MouseEvent e) {
      Point pixel = zoom == null ? null : new Point(zoom.column(e.getX()), zoom.row(e.getY()));
      boolean inside =
          pixel != null
              && pixel.x >= 0
              && pixel.y >= 0
              && pixel.x < picture.getWidth()
              && pixel.y < picture.getHeight();
      pointed.accept(inside ? pixel : null);
    }

    @Override
    public void mouseExited(MouseEvent e) {
      pointed.accept(null);
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
      zoomBy(-e.getPreciseWheelRotation(), e.getX(), e.getY());
    }
  }
}

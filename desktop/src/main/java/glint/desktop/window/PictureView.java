package glint.desktop.window;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.event.MouseInputAdapter;

/** Shows a picture, larger or smaller, and what is drawn over it. */
final class PictureView extends JComponent {

  private static final long serialVersionUID = 1;

  /** By how much a notch of the wheel zooms. */
  private static final double NOTCH = 1.2;

  /** Draws over a picture, in units of the view. */
  interface Overlay {
    /** Draws over a picture that is shown at a place. */
    void paint(Graphics2D g, Zoom zoom);
  }

  private final transient Consumer<Point> pointed;
  private final transient List<Overlay> overlays = new ArrayList<>();
  private transient BufferedImage picture;
  private transient Dimension size;
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
    MouseInputAdapter pointer = new Pointer();
    addMouseListener(pointer);
    addMouseMotionListener(pointer);
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

  /**
   * Shows a picture, a bound property; if the size is another than before it is fitted.
   *
   * @param full the columns and rows that it has, or is stretched to
   */
  void show(BufferedImage next, Dimension full) {
    boolean same = full.equals(size);
    BufferedImage before = picture;
    picture = next;
    size = full;
    if (!same) {
      fit();
    }
    repaint();
    firePropertyChange("picture", before, next);
  }

  /** Draws something more over the picture, last. */
  void add(Overlay overlay) {
    overlays.add(overlay);
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
      zoom = Zoom.fit(size.width, size.height, getWidth(), getHeight());
      repaint();
    }
  }

  /** Shows every pixel as one of the display. */
  void oneToOne() {
    if (picture != null) {
      double unit = 1 / getGraphicsConfiguration().getDefaultTransform().getScaleX();
      change(Zoom.centred(unit, size.width, size.height, getWidth(), getHeight()));
    }
  }

  /** Zooms about the middle of the view, by notches of a wheel. */
  void zoomBy(int notches) {
    zoomBy(notches, getWidth() / 2.0, getHeight() / 2.0);
  }

  /** Zooms about a place of the view. */
  void zoomBy(double notches, double x, double y) {
    if (zoom != null) {
      change(zoom.about(Math.pow(NOTCH, notches), x, y));
    }
  }

  /** Moves the picture in the view. */
  void shift(double dx, double dy) {
    if (zoom != null) {
      change(zoom.moved(dx, dy));
    }
  }

  /** Returns the pixel at a place of the view, or null if none is there. */
  Point pixel(Point at) {
    if (zoom == null) {
      return null;
    }
    Point pixel = new Point(zoom.column(at.x), zoom.row(at.y));
    return new Rectangle(size).contains(pixel) ? pixel : null;
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
    double stretch = (double) size.width / picture.getWidth();
    boolean smooth = g.getTransform().getScaleX() * zoom.scale() < 1 || stretch > 1;
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION,
        smooth
            ? RenderingHints.VALUE_INTERPOLATION_BILINEAR
            : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    AffineTransform place = AffineTransform.getTranslateInstance(zoom.x(), zoom.y());
    place.scale(zoom.scale() * stretch, zoom.scale() * size.height / picture.getHeight());
    g.drawImage(picture, place, null);
    for (Overlay overlay : overlays) {
      overlay.paint(g, zoom);
    }
    g.dispose();
  }

  private final class Pointer extends MouseInputAdapter {
    @Override
    public void mouseMoved(MouseEvent e) {
      pointed.accept(pixel(e.getPoint()));
    }

    @Override
    public void mouseExited(MouseEvent e) {
      pointed.accept(null);
    }
  }
}

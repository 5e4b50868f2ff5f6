package glint.desktop.window;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.List;

/** Frames the parts of a picture that are in work. */
final class WorkMarks implements PictureView.Overlay {

  private static final Color DARK = new Color(0, 0, 0, 140);
  private static final Color LIGHT = new Color(255, 190, 60);

  private List<Rectangle> parts = List.of();

  /** Frames these parts from now on. */
  void mark(List<Rectangle> next) {
    parts = next;
  }

  @Override
  public void paint(Graphics2D g, Zoom zoom) {
    for (Rectangle part : parts) {
      g.setColor(DARK);
      g.setStroke(new BasicStroke(3));
      g.draw(zoom.of(part));
      g.setColor(LIGHT);
      g.setStroke(new BasicStroke(1));
      g.draw(zoom.of(part));
    }
  }
}

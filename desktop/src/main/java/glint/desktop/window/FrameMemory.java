package glint.desktop.window;

import java.awt.Component;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JSplitPane;

/** Puts a window where it was the last time, as large as it was, and remembers that. */
final class FrameMemory {

  private static final String SIDE = "side";
  private static final String LIST = "list";
  private static final String MAXIMIZED = "maximized";

  /** So much of a window must be on a screen to be found again, across and down. */
  private static final int SEEN = 100;

  private final Remembered memory;
  private final JFrame frame;
  private final JSplitPane outer;
  private final JSplitPane inner;

  /**
   * Sets up what is remembered: the window, and the widths of what stands at its sides.
   *
   * @param outer has the list to the left, and to the right the inner one
   * @param inner has the panel to the right
   */
  FrameMemory(Remembered memory, JFrame frame, JSplitPane outer, JSplitPane inner) {
    this.memory = memory;
    this.frame = frame;
    this.outer = outer;
    this.inner = inner;
  }

  /** Gives the window its place; call it before it is seen. */
  void restore() {
    frame.pack();
    Optional<Rectangle> bounds = memory.bounds().filter(FrameMemory::isOnScreen);
    bounds.ifPresentOrElse(frame::setBounds, () -> frame.setLocationByPlatform(true));
    frame.validate();
    outer.setDividerLocation(width(LIST, outer.getLeftComponent()));
    frame.validate();
    int side = width(SIDE, inner.getRightComponent());
    inner.setDividerLocation(inner.getWidth() - inner.getDividerSize() - side);
    if (memory.number(MAXIMIZED).orElse(0) == 1) {
      frame.setExtendedState(JFrame.MAXIMIZED_BOTH);
    }
  }

  /** Remembers the place. */
  void keep() {
    boolean maximized = (frame.getExtendedState() & JFrame.MAXIMIZED_BOTH) != 0;
    memory.number(MAXIMIZED, maximized ? 1 : 0);
    if (!maximized) {
      memory.bounds(frame.getBounds());
    }
    keep(LIST, outer.getLeftComponent());
    keep(SIDE, inner.getRightComponent());
  }

  private void keep(String name, Component part) {
    if (part.isVisible()) {
      memory.number(name, part.getWidth());
    }
  }

  private int width(String name, Component part) {
    return memory.number(name).orElse(part.getPreferredSize().width);
  }

  private static boolean isOnScreen(Rectangle bounds) {
    GraphicsEnvironment here = GraphicsEnvironment.getLocalGraphicsEnvironment();
    for (GraphicsDevice screen : here.getScreenDevices()) {
      Rectangle seen = bounds.intersection(screen.getDefaultConfiguration().getBounds());
      if (seen.width >= SEEN && seen.height >= SEEN) {
        return true;
      }
    }
    return false;
  }
}

package glint.desktop.window;

import java.awt.Dimension;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JFrame;

/** Puts a window where it was the last time, as large as it was, and remembers that. */
final class FrameMemory {

  private static final String SIDE = "side";
  private static final String LIST = "list";
  private static final String MAXIMIZED = "maximized";

  /** So much of a window must be on a screen to be found again, across and down. */
  private static final int SEEN = 100;

  private final Remembered memory;
  private final JFrame frame;
  private final JComponent list;
  private final JComponent side;

  /** Sets up what is remembered: the window, and the widths of what stands at its sides. */
  FrameMemory(Remembered memory, JFrame frame, JComponent list, JComponent side) {
    this.memory = memory;
    this.frame = frame;
    this.list = list;
    this.side = side;
  }

  /** Gives the window its place; call it before it is seen. */
  void restore() {
    width(list, LIST);
    width(side, SIDE);
    frame.pack();
    Optional<Rectangle> bounds = memory.bounds().filter(FrameMemory::isOnScreen);
    bounds.ifPresentOrElse(frame::setBounds, () -> frame.setLocationByPlatform(true));
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
    memory.number(LIST, list.getWidth());
    memory.number(SIDE, side.getWidth());
  }

  private void width(JComponent part, String name) {
    int height = part.getPreferredSize().height;
    memory.number(name).ifPresent(width -> part.setPreferredSize(new Dimension(width, height)));
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

package glint.desktop.window;

import glint.image.Image;
import java.awt.BorderLayout;
import java.awt.Point;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;

/** How far the render is, how fast and how good, and the pixel under the pointer. */
final class StatusBar extends JPanel {

  private static final long serialVersionUID = 1;

  private static final int PARTS = 1000;

  private final JProgressBar bar = new JProgressBar(0, PARTS);
  private final JLabel status = new JLabel(" ");
  private final JLabel pixel = new JLabel(" ");

  /** Makes an empty bar. */
  StatusBar() {
    super(new BorderLayout(12, 0));
    setBorder(BorderFactory.createEmptyBorder(6, 10, 6, 10));
    bar.getAccessibleContext().setAccessibleName("Progress");
    status.setName("status");
    pixel.setName("pixel");
    add(bar, BorderLayout.WEST);
    add(status, BorderLayout.CENTER);
    add(pixel, BorderLayout.EAST);
  }

  /** Tells where a render stands. */
  void show(Snapshot s) {
    bar.setValue((int) (PARTS * s.done()));
    bar.setIndeterminate(s.state() == Snapshot.State.PREPARING);
    if (s.state() == Snapshot.State.MOVING) {
      status.setText(String.format(Locale.ROOT, "moving, %.0f ms a picture", 1e3 * s.seconds()));
      return;
    }
    StringBuilder words = new StringBuilder(s.state().words);
    if (!s.message().isEmpty()) {
      words.append(": ").append(s.message());
    }
    words.append(String.format(Locale.ROOT, ", %.1f s", s.seconds()));
    if (s.rays() > 0) {
      double rate = s.rays() / Math.max(s.seconds(), 1e-3);
      words.append(String.format(Locale.ROOT, ", %.2f M rays/s", rate * 1e-6));
    }
    if (s.state() == Snapshot.State.RENDERING
        && s.left() >= 1
        && s.left() < Double.POSITIVE_INFINITY) {
      words.append(String.format(Locale.ROOT, ", about %.0f s left", s.left()));
    }
    if (s.error() < Double.POSITIVE_INFINITY) {
      words.append(String.format(Locale.ROOT, ", error %.2g levels", s.error()));
    }
    status.setText(words.toString());
  }

  /** Tells where the pointer is and what the image has there; nothing if either is null. */
  void point(Point at, Image image) {
    if (at == null || image == null) {
      pixel.setText(" ");
      return;
    }
    double[] rgb = image.rgb();
    int i = 3 * (at.y * image.width() + at.x);
    pixel.setText(
        String.format(
            Locale.ROOT, "%d, %d: %.5f %.5f %.5f", at.x, at.y, rgb[i], rgb[i + 1], rgb[i + 2]));
  }
}

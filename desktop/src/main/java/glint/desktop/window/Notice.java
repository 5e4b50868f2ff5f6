package glint.desktop.window;

import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.Timer;

/** Says for a while what has been done, or could not be. */
final class Notice extends JLabel {

  private static final long serialVersionUID = 1;

  private static final int MILLIS = 8000;

  private final Timer timer = new Timer(MILLIS, e -> setText(" "));

  /** Makes one that says nothing. */
  Notice() {
    super(" ");
    setName("notice");
    setBorder(BorderFactory.createEmptyBorder(0, 10, 0, 10));
    timer.setRepeats(false);
  }

  /** Says something, in place of what was said before. */
  void say(String text) {
    setText(text);
    setToolTipText(text);
    timer.restart();
  }
}

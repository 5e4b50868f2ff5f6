package glint.desktop.window;

import java.awt.Dimension;
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
    super(" ", TRAILING);
    setName("notice");
    setBorder(BorderFactory.createEmptyBorder(0, 10, 0, 10));
    timer.setRepeats(false);
  }

  /** Returns that it takes whatever room there is: a text that is cut has a tip. */
  @Override
  public Dimension getMinimumSize() {
    return new Dimension(0, super.getMinimumSize().height);
  }

  /** Says something, in place of what was said before. */
  void say(String text) {
    setText(text);
    setToolTipText(text);
    timer.restart();
  }
}

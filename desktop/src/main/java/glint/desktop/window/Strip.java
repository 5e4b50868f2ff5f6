package glint.desktop.window;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;

/** What stands below a picture that is not plain: the meaning of colours, or a divider to move. */
final class Strip extends JPanel {

  private static final long serialVersionUID = 1;

  private static final int PARTS = 1000;
  private static final String LEGEND = "legend";
  private static final String DIVIDER = "divider";

  private final JLabel left = new JLabel();
  private final JLabel right = new JLabel();
  private final JLabel words = new JLabel(" ");
  private final Legend legend = new Legend();
  private final JSlider slider = new JSlider(0, PARTS, PARTS / 2);
  private final CardLayout cards = new CardLayout();
  private final JPanel middle = new JPanel(cards);

  /**
   * Makes one that is not seen.
   *
   * @param moved hears of the divider when it moves
   */
  Strip(Runnable moved) {
    super(new BorderLayout(10, 2));
    setBorder(BorderFactory.createEmptyBorder(6, 10, 2, 10));
    slider.setName("divider");
    slider.getAccessibleContext().setAccessibleName("Divider between the images");
    slider.addChangeListener(e -> moved.run());
    words.setName("metrics");
    words.setHorizontalAlignment(JLabel.CENTER);
    words.setMinimumSize(new Dimension(0, 0));
    middle.add(legend, LEGEND);
    middle.add(slider, DIVIDER);
    add(left, BorderLayout.WEST);
    add(middle, BorderLayout.CENTER);
    add(right, BorderLayout.EAST);
    add(words, BorderLayout.SOUTH);
    setVisible(false);
  }

  /** Shows what colours mean. */
  void showLegend(Scale scale, String text) {
    legend.show(scale);
    show(scale.title(), LEGEND, "", text);
  }

  /** Shows the divider between two images. */
  void showDivider(String leftName, String rightName, String text) {
    show(leftName, DIVIDER, rightName, text);
  }

  /** Returns where the divider is, 0 to 1. */
  double divider() {
    return slider.getValue() / (double) PARTS;
  }

  private void show(String before, String what, String after, String text) {
    left.setText(before);
    right.setText(after);
    words.setText(text);
    words.setVisible(!text.isBlank());
    cards.show(middle, what);
    setVisible(true);
    revalidate();
  }
}

package glint.desktop.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.UIManager;

/** What the colours of a map mean. */
final class Legend extends JPanel {

  private static final long serialVersionUID = 1;

  private static final int BAR = 12;
  private static final int GAP = 3;
  private static final int SIDE = 24;

  private transient Scale scale = new Scale("", 1, 10);

  /** Makes a legend of nothing. */
  Legend() {
    setName("legend");
  }

  /** Shows a scale instead of the one before. */
  void show(Scale next) {
    scale = next;
    setToolTipText(next.title());
    repaint();
  }

  /** Returns what is shown. */
  Scale scale() {
    return scale;
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(320, BAR + GAP + getFontMetrics(getFont()).getHeight());
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    int width = getWidth() - 2 * SIDE;
    for (int x = 0; x < width; x++) {
      g.setColor(new Color(Palette.colour((x + 0.5) / width)));
      g.fillRect(SIDE + x, 0, 1, BAR);
    }
    g.setColor(UIManager.getColor("Label.foreground"));
    FontMetrics font = g.getFontMetrics();
    for (double value = scale.low(); value <= 1.001 * scale.high(); value *= 10) {
      int x = SIDE + (int) Math.rint(scale.place(value) * width);
      String words = words(value);
      g.drawLine(x, BAR, x, BAR + 2);
      g.drawString(words, x - font.stringWidth(words) / 2, BAR + GAP + font.getAscent());
    }
    g.dispose();
  }

  private static String words(double value) {
    return value < 1
        ? String.valueOf((float) value)
        : String.format(Locale.ROOT, "%,d", Math.round(value));
  }
}

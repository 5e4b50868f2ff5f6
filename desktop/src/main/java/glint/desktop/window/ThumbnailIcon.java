package glint.desktop.window;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.UIManager;

/** Draws a small picture, or the place where one will be. */
final class ThumbnailIcon implements Icon {

  private static final int WIDTH = Thumbnails.WIDTH / 2;
  private static final int HEIGHT = Thumbnails.HEIGHT / 2;

  private final Optional<BufferedImage> picture;

  /** Makes an icon. */
  ThumbnailIcon(Optional<BufferedImage> picture) {
    this.picture = picture;
  }

  @Override
  public int getIconWidth() {
    return WIDTH;
  }

  @Override
  public int getIconHeight() {
    return HEIGHT;
  }

  @Override
  public void paintIcon(Component c, Graphics graphics, int x, int y) {
    Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    if (picture.isPresent()) {
      int width = picture.get().getWidth() / 2;
      int height = picture.get().getHeight() / 2;
      g.drawImage(
          picture.get(), x + (WIDTH - width) / 2, y + (HEIGHT - height) / 2, width, height, null);
    } else {
      g.setColor(UIManager.getColor("Separator.foreground"));
      g.drawRect(x, y, WIDTH - 1, HEIGHT - 1);
    }
    g.dispose();
  }
}

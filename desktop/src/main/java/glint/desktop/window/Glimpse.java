package glint.desktop.window;

import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Scene;
import glint.scene.World;
import java.awt.image.BufferedImage;

/** A picture of few pixels, each of one ray. */
final class Glimpse {

  private Glimpse() {}

  /** Renders a picture of a world in so many times fewer columns and rows; takes its time. */
  static BufferedImage of(World world, Scene picture, int fewer) {
    int width = (picture.width() - 1) / fewer + 1;
    int height = (picture.height() - 1) / fewer + 1;
    Scene small = picture.seenBy(picture.camera(), width, height);
    RenderSettings one = RenderSettings.of(small).sampled(1, 0);
    return Pictures.of(
        new Renderer(world.seenIn(small), one).render(Progress.NONE).image(), small.transfer());
  }
}

package glint.desktop.window;

import glint.image.Image;
import java.awt.image.BufferedImage;

/** Colours for numbers, from dark blue to pale yellow: brighter is more, also without colour. */
final class Palette {

  /** Viridis, by Smith and van der Walt, at every eighth of its length. */
  private static final int[] COLOURS = {
    0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725
  };

  private Palette() {}

  /** Returns the colour of a place on the scale, 0 to 1; what is outside has that of its end. */
  static int colour(double place) {
    double at = Math.max(0, Math.min(1, place)) * (COLOURS.length - 1);
    int i = (int) Math.min(at, COLOURS.length - 2);
    double part = at - i;
    int rgb = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int a = COLOURS[i] >> shift & 255;
      int b = COLOURS[i + 1] >> shift & 255;
      rgb |= (int) Math.rint(a + part * (b - a)) << shift;
    }
    return rgb;
  }

  /** Returns the picture of the first channel of a map. */
  static BufferedImage picture(Image map, Scale scale) {
    int width = map.width();
    int[] codes = new int[width * map.height()];
    for (int i = 0; i < codes.length; i++) {
      codes[i] = colour(scale.place(map.rgb()[3 * i]));
    }
    return Pictures.of(codes, width, map.height());
  }
}

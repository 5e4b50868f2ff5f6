package glint.bench;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/**
 * Writes the images that scenes/gallery.yaml lays on surfaces: a crate's side, floor boards, and a
 * map of a world that does not exist. All come from noise, and have palettes, no alpha and no
 * colour profile, so that every platform decodes them alike.
 */
public final class TextureImages {

  private static final int SIDE = 256;
  private static final int FRAME = 40;

  /** Dark to light wood, and a little redder. */
  private static final int[] WOOD = {0x2b1a0c, 0x6b4423, 0x9a6a38, 0xc79a5b, 0xe0be82};

  private static final int[] BOARDS = {0x150b06, 0x3a2013, 0x55301c, 0x6d4127, 0x835335};

  /** Deep to shallow sea, beach, low to high land, snow. */
  private static final int[] WORLD = {
    0x0a1c44, 0x10306a, 0x184a8c, 0x2a6ea8, 0x5aa0c0, 0xd8c890, 0x5c8a3c, 0x3a6b2c, 0x6b6a3a,
    0x7a5c3c, 0x8a7660, 0xf0f0f4
  };

  private static final double SHORE = 4.6 / (WORLD.length - 1);

  /** Returns what a pixel shows, 0 to 1 along a ramp of colours. */
  private interface Painter {
    double at(int x, int y);
  }

  private TextureImages() {}

  /** Writes them into the folder that is given. */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    write(folder.resolve("crate.png"), SIDE, SIDE, WOOD, TextureImages::crate);
    write(folder.resolve("boards.png"), SIDE, SIDE, BOARDS, TextureImages::boards);
    write(folder.resolve("world.png"), 640, 320, WORLD, (x, y) -> world(x / 640.0, y / 320.0));
  }

  private static void write(Path file, int width, int height, int[] ramp, Painter painter)
      throws IOException {
    BufferedImage image =
        new BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, palette(ramp));
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        double value = Math.min(Math.max(painter.at(x, y), 0), 1);
        image.getRaster().setSample(x, y, 0, (int) (127 * value + 0.5));
      }
    }
    ImageIO.write(image, "png", file.toFile());
  }

  private static IndexColorModel palette(int[] ramp) {
    byte[][] channels = new byte[3][128];
    for (int i = 0; i < 128; i++) {
      double place = i / 127.0 * (ramp.length - 1);
      int below = (int) Math.min(place, ramp.length - 2);
      for (int c = 0; c < 3; c++) {
        int from = ramp[below] >> 16 - 8 * c & 0xff;
        int to = ramp[below + 1] >> 16 - 8 * c & 0xff;
        channels[c][i] = (byte) Math.round(from + (place - below) * (to - from));
      }
    }
    return new IndexColorModel(7, 128, channels[0], channels[1], channels[2]);
  }

  /** A frame of four boards and a brace over upright planks. */
  private static double crate(int x, int y) {
    int right = SIDE - 1 - x;
    int lower = SIDE - 1 - y;
    int across = Math.min(y, lower);
    int upright = Math.min(x, right);
    if (across < FRAME) {
      return board(x, across, FRAME, y < FRAME ? 1 : 2) - nails(upright, across);
    }
    if (upright < FRAME) {
      return board(y, upright, FRAME, x < FRAME ? 3 : 4);
    }
    double brace = (x - lower) / Math.sqrt(2) + 18;
    if (brace > 0 && brace < 36) {
      return board((x + lower) / Math.sqrt(2), brace, 36, 5);
    }
    double plank = (x - FRAME) * 6.0 / (SIDE - 2 * FRAME);
    int number = (int) plank;
    double width = (SIDE - 2 * FRAME) / 6.0;
    double depth = Math.min(Math.min(across, upright) - FRAME, 12) / 12.0;
    double besideBrace = brace < 0 ? -brace : brace - 36;
    depth = Math.min(depth, Math.min(besideBrace, 8) / 8);
    return board(y, (plank - number) * width, width, 6 + number) * (0.55 + 0.25 * depth);
  }

  /** Two dark points at each end. */
  private static double nails(int along, int across) {
    double dx = along - FRAME / 2.0;
    double dy = Math.abs(across - FRAME / 2.0) - 9;
    return dx * dx + dy * dy < 5 ? 0.5 : 0;
  }

  /** Four boards that go on beyond the edges, each cut once. */
  private static double boards(int x, int y) {
    int width = SIDE / 4;
    int number = y / width;
    int cut = Math.floorMod(x + 97 * number, SIDE);
    double end = Math.min(cut, SIDE - cut) < 2 ? 0.5 : 1;
    // The grain is mixed from two places, so that both edges show the same.
    double share = (double) cut / SIDE;
    double here = board(cut, y % width, width, 20 + number);
    double before = board(cut - SIDE, y % width, width, 20 + number);
    return end * ((1 - share) * here + share * before);
  }

  /** The grain of a board, with dark edges. */
  private static double board(double along, double across, double width, int number) {
    double bend = 6 * fractal(0.01 * along, 0.02 * across, 9.5 * number, 2);
    double grain = fractal(0.015 * along, 0.35 * (across + bend), 7.3 * number, 4);
    double tone = 0.12 * (noise(0.5, 0.5, 3.7 * number) - 0.5);
    double edge = Math.min(Math.min(across, width - 1 - across), 2.5) / 2.5;
    return (0.25 + 0.75 * grain + tone) * (0.35 + 0.65 * Math.max(edge, 0));
  }

  /** Land and sea by height, ice by latitude; a square of 2 by 1 around a globe. */
  private static double world(double u, double v) {
    double longitude = 2 * Math.PI * u;
    double latitude = Math.PI * (0.5 - v);
    double x = Math.cos(latitude) * Math.sin(longitude);
    double y = Math.sin(latitude);
    double z = Math.cos(latitude) * Math.cos(longitude);
    double height = fractal(1.7 * x + 5.2, 1.7 * y + 1.3, 1.7 * z + 8.1, 6) - 0.5;
    double cold = Math.abs(y) + 0.5 * (fractal(4 * x, 4 * y + 40, 4 * z, 4) - 0.5);
    if (cold > 0.9) {
      return 1;
    }
    return height < 0
        ? SHORE * (1 + 4 * Math.max(height, -0.25))
        : SHORE + 0.08 + 2.2 * height * (0.93 - SHORE);
  }

  /** Noise of halving size and weight, 0 to 1, 1/2 on average. */
  private static double fractal(double x, double y, double z, int octaves) {
    double sum = 0;
    double weights = 0;
    double weight = 1;
    for (int i = 0; i < octaves; i++) {
      double size = 1 << i;
      sum += weight * noise(size * x, size * y, size * z + 31 * i);
      weights += weight;
      weight *= 0.55;
    }
    return sum / weights;
  }

  /** Values at whole places, 0 to 1, smoothly interpolated. */
  private static double noise(double x, double y, double z) {
    double x0 = Math.floor(x);
    double y0 = Math.floor(y);
    double z0 = Math.floor(z);
    double sum = 0;
    for (int corner = 0; corner < 8; corner++) {
      int dx = corner & 1;
      int dy = corner >> 1 & 1;
      int dz = corner >> 2;
      double weight = share(x - x0, dx) * share(y - y0, dy) * share(z - z0, dz);
      sum += weight * value((long) x0 + dx, (long) y0 + dy, (long) z0 + dz);
    }
    return sum;
  }

  private static double share(double t, int end) {
    double smooth = t * t * (3 - 2 * t);
    return end == 1 ? smooth : 1 - smooth;
  }

  /** A number, 0 to 1, that only looks random. */
  private static double value(long x, long y, long z) {
    long mixed = (x * 0x9e3779b97f4a7c15L + y) * 0xbf58476d1ce4e5b9L + z;
    mixed = (mixed ^ mixed >>> 30) * 0x94d049bb133111ebL;
    mixed = (mixed ^ mixed >>> 27) * 0x9e3779b97f4a7c15L;
    return (mixed >>> 11) * 0x1p-53;
  }
}

package glint.render;

import glint.optics.ImageTexture;
import glint.optics.Texel;
import glint.scene.Prepared;
import java.util.Arrays;

/**
 * A pixel that shows one image on one surface: what the colours of the image come to is found from
 * the image itself, without rays; scratch.
 *
 * <p>From corner to corner of the pixel three things are taken to run evenly: where in the image
 * one looks, the light that its colours are multiplied by, and all other radiance.
 */
final class Inlay {

  /** A pixel that shows more of an image, in pixels of that across or down, is sampled. */
  private static final double LARGEST = 6;

  /** Places across and down: at first, and at most. */
  private static final int FEWEST = 2;

  private static final int MOST = 8;

  /** An image that lies elsewhere by more than so many of its pixels does not run evenly. */
  private static final double ELSEWHERE = 0.25;

  /** What other images show is seen from a variance, in levels², that is more than this. */
  private static final double VISIBLE = 1;

  /** More places are not taken for less than this share of the variance accepted. */
  private static final double ENOUGH = 0.3;

  private final double enough;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Prepared scene;
  private final PrintBends bends;
  private final Texel texel = new Texel();

  /** The four corners of the pixel at hand: of {@link #a}, below that {@link #c}. */
  private int a;

  private int c;

  /** The numbers at the ends of a row of places. */
  private final double[] left = new double[Prints.NUMBERS];

  private final double[] right = new double[Prints.NUMBERS];

  /** Sums over places: of radiance, its square, radiance at every other place, and colour. */
  private final double[] sum = new double[3];

  private final double[] squares = new double[3];
  private final double[] others = new double[3];
  private final double[] colours = new double[3];

  /** Radiance at the last place. */
  private final double[] radiance = new double[3];

  /** The mean radiance over the pixel. */
  final double[] mean = new double[3];

  /** The variance of that, in levels². */
  double variance;

  Inlay(CornerGrid corners, LevelScale scale, Prepared scene, double levels) {
    enough = ENOUGH * levels * levels;
    this.corners = corners;
    this.scale = scale;
    this.scene = scene;
    bends = new PrintBends(corners);
  }

  /** Returns whether a pixel whose corners have one signature shows an image that runs evenly. */
  boolean suits(int x, int y) {
    turn(x, y);
    return corners.prints.has(a)
        && across() <= LARGEST
        && down() <= LARGEST
        && bends.find(x, y)
        && bends.elsewhere() <= ELSEWHERE
        && (!corners.leapsBeyond(x, y) || restVariance() <= VISIBLE);
  }

  /** Turns to a pixel that suits. */
  void turn(int x, int y) {
    a = y * corners.stride + x;
    c = a + corners.stride;
  }

  /**
   * Finds the mean over a pixel, and its variance, from as many places as that takes.
   *
   * @param finer how many times finer the image is looked at than is enough by itself
   */
  void look(int x, int y, int finer) {
    turn(x, y);
    bends.find(x, y);
    double accepted = enough / (finer * finer * finer * finer);
    double across = across();
    double down = down();
    double rest;
    int places = FEWEST;
    do {
      int inRow = across < down / 2 ? places / 2 : places;
      int rows = down < across / 2 ? places / 2 : places;
      integrate(inRow, rows);
      double apart = Math.max(across / inRow, down / rows);
      rest = find(inRow * rows, apart);
      places *= places < MOST / 2 && rest > (apart < 1 ? 64 : 4) * accepted ? 4 : 2;
    } while (rest > accepted && places <= finer * MOST);
    if (corners.leapsBeyond(x, y)) {
      variance += restVariance() / 4;
    }
  }

  /**
   * Finds mean and variance from the sums.
   *
   * @param apart how far places are apart, in pixels of the image
   * @return the part of the variance that more places take away
   */
  private double find(int count, double apart) {
    double elsewhere = bends.elsewhere();
    // The error of the midpoint rule is quadratic; pixels of an image know nothing of each other.
    double unseen = Math.min(1, apart * apart * apart * apart) / count;
    double less = 0;
    variance = 0;
    for (int i = 0; i < 3; i++) {
      mean[i] = sum[i] / count;
      double spread = Math.max(0, squares[i] / count - mean[i] * mean[i]);
      double half = others[i] / (0.5 * count) - mean[i]; // of what the halves differ by
      double coarse = Math.max(half * half, unseen * spread);
      double bend = bends.error(i, colours[i] / count);
      double error = bend * bend + elsewhere * elsewhere * spread + coarse;
      variance += scale.squaredError(mean[i], Math.sqrt(error)) / 3;
      less += scale.squaredError(mean[i], Math.sqrt(coarse)) / 3;
    }
    return less;
  }

  /** Returns, in scratch, the radiance at a place in the pixel at hand. */
  double[] at(double u, double v) {
    fill(v);
    place(u);
    return radiance;
  }

  /** Returns how much of the image the pixel shows across: in pixels of the image. */
  private double across() {
    return Math.max(apart(a, a + 1), apart(c, c + 1));
  }

  private double down() {
    return Math.max(apart(a, c), apart(a + 1, c + 1));
  }

  private double apart(int one, int two) {
    double[] seen = corners.prints.seen;
    int i = Prints.NUMBERS * one;
    int j = Prints.NUMBERS * two;
    return Math.max(Math.abs(seen[i] - seen[j]), Math.abs(seen[i + 1] - seen[j + 1]));
  }

  /** Sums up over an even number of places across, and of rows. */
  private void integrate(int across, int down) {
    Arrays.fill(sum, 0);
    Arrays.fill(squares, 0);
    Arrays.fill(others, 0);
    Arrays.fill(colours, 0);
    for (int row = 0; row < down; row++) {
      fill((row + 0.5) / down);
      for (int i = 0; i < across; i++) {
        place((i + 0.5) / across);
        boolean other = ((row ^ i) & 1) == 0;
        for (int channel = 0; channel < 3; channel++) {
          double one = radiance[channel];
          sum[channel] += one;
          squares[channel] += one * one;
          others[channel] += other ? one : 0;
        }
        colours[0] += texel.r;
        colours[1] += texel.g;
        colours[2] += texel.b;
      }
    }
  }

  private void fill(double v) {
    double[] seen = corners.prints.seen;
    for (int i = 0; i < Prints.NUMBERS; i++) {
      int above = Prints.NUMBERS * a + i;
      int below = Prints.NUMBERS * c + i;
      left[i] = seen[above] + v * (seen[below] - seen[above]);
      above += Prints.NUMBERS;
      below += Prints.NUMBERS;
      right[i] = seen[above] + v * (seen[below] - seen[above]);
    }
  }

  private void place(double u) {
    texel.x = left[0] + u * (right[0] - left[0]);
    texel.y = left[1] + u * (right[1] - left[1]);
    image().atPlace(texel);
    radiance[0] = rest(0, u) + gain(0, u) * texel.r;
    radiance[1] = rest(1, u) + gain(1, u) * texel.g;
    radiance[2] = rest(2, u) + gain(2, u) * texel.b;
  }

  private ImageTexture image() {
    return scene.image(corners.first[a]);
  }

  private double gain(int channel, double u) {
    int i = Prints.GAIN + channel;
    return left[i] + u * (right[i] - left[i]);
  }

  private double rest(int channel, double u) {
    int i = Prints.REST + channel;
    return left[i] + u * (right[i] - left[i]);
  }

  /** Returns, in levels², the variance of what is not of the image at the four corners. */
  private double restVariance() {
    double sum = 0;
    for (int channel = 0; channel < 3; channel++) {
      int number = Prints.REST + channel;
      double rest = 0;
      double shown = 0;
      for (int i = 0; i < 4; i++) {
        rest += 0.25 * corners.prints.seen[Prints.NUMBERS * corner(i) + number];
        shown += 0.25 * corners.rgb[3 * corner(i) + channel];
      }
      for (int i = 0; i < 4; i++) {
        double here = corners.prints.seen[Prints.NUMBERS * corner(i) + number];
        sum += scale.squaredDifference(shown - rest + here, shown);
      }
    }
    return sum / 12;
  }

  private int corner(int i) {
    return (i < 2 ? a : c) + (i & 1);
  }
}

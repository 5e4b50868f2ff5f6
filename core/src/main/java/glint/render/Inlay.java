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
  private static final double LARGEST = 16;

  /** Places across and down: at first, and at most. */
  private static final int FEWEST = 2;

  private static final int MOST = 8;

  /** An image that lies elsewhere by more than so many of its pixels does not run evenly. */
  private static final double ELSEWHERE = 0.25;

  /** What other images show is seen from a variance, in levels², that is more than this. */
  private static final double VISIBLE = 1;

  /** A step counts as so many bends: 12/√12, see {@link Bends}. */
  private static final double STEP = 2 * Math.sqrt(3);

  private static final double TWENTY_FOURTH = 1 / 24.0;

  /** More places are not taken for less than this share of the variance accepted. */
  private static final double ENOUGH = 0.1;

  private final double enough;
  private final CornerGrid corners;
  private final LevelScale scale;
  private final Prepared scene;
  private final Texel texel = new Texel();

  /** The four corners of the pixel at hand: of {@link #a}, below that {@link #c}. */
  private int a;

  private int c;

  /** The second differences along its sides, without their signs and summed up, by number. */
  private final double[] bends = new double[Prints.NUMBERS];

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
  }

  /** Returns whether a pixel whose corners have one signature shows an image that runs evenly. */
  boolean suits(int x, int y) {
    turn(x, y);
    return corners.prints.has(a)
        && across() <= LARGEST
        && down() <= LARGEST
        && bend(x, y)
        && elsewhere() <= ELSEWHERE
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
    bend(x, y);
    double accepted = enough / (finer * finer * finer * finer);
    double across = across();
    double down = down();
    double rest;
    int places = FEWEST;
    do {
      int inRow = across < down / 2 ? places / 2 : places;
      int rows = down < across / 2 ? places / 2 : places;
      integrate(inRow, rows);
      rest = find(inRow * rows, Math.max(across / inRow, down / rows));
      places *= 2;
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
    double elsewhere = elsewhere();
    // The error of the midpoint rule is quadratic; pixels of an image know nothing of each other.
    double unseen = Math.min(1, apart * apart * apart * apart) / count;
    double less = 0;
    variance = 0;
    for (int i = 0; i < 3; i++) {
      mean[i] = sum[i] / count;
      double spread = Math.max(0, squares[i] / count - mean[i] * mean[i]);
      double half = others[i] / (0.5 * count) - mean[i]; // of what the halves differ by
      double coarse = Math.max(half * half, unseen * spread);
      double bend =
          TWENTY_FOURTH * (bends[Prints.REST + i] + bends[Prints.GAIN + i] * colours[i] / count);
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
    double[] seen = corners.prints.seen;
    double sum = 0;
    for (int i = Prints.REST; i < Prints.REST + 3; i++) {
      int one = Prints.NUMBERS * a + i;
      int two = Prints.NUMBERS * c + i;
      int channel = i - Prints.REST;
      double colour =
          0.25 * (shown(a, channel) + shown(c, channel))
              + 0.25 * (shown(a + 1, channel) + shown(c + 1, channel));
      double rest =
          0.25 * (seen[one] + seen[one + Prints.NUMBERS] + seen[two] + seen[two + Prints.NUMBERS]);
      sum += scale.squaredDifference(colour - rest + seen[one], colour);
      sum += scale.squaredDifference(colour - rest + seen[one + Prints.NUMBERS], colour);
      sum += scale.squaredDifference(colour - rest + seen[two], colour);
      sum += scale.squaredDifference(colour - rest + seen[two + Prints.NUMBERS], colour);
    }
    return sum / 12;
  }

  private double shown(int corner, int channel) {
    return corners.rgb[3 * corner + channel];
  }

  /** Returns by how much the image lies elsewhere than if it ran evenly: in its pixels. */
  private double elsewhere() {
    return TWENTY_FOURTH * Math.sqrt(bends[0] * bends[0] + bends[1] * bends[1]);
  }

  /** Finds the bends of the four sides; returns whether enough around is of a kind for that. */
  private boolean bend(int x, int y) {
    Arrays.fill(bends, 0);
    return bend(a, 1, x, corners.stride)
        && bend(c, 1, x, corners.stride)
        && bend(a, corners.stride, y, corners.rows)
        && bend(a + 1, corners.stride, y, corners.rows);
  }

  /** Adds the bends of a side, like {@link Bends}; returns whether there is anything beside it. */
  private boolean bend(int corner, int step, int at, int count) {
    long[] met = corners.signature;
    double[] seen = corners.prints.seen;
    boolean before = at > 0 && met[corner - step] == met[corner];
    boolean after = at + 2 < count && met[corner + 2 * step] == met[corner];
    int next = Prints.NUMBERS * step;
    for (int number = 0; number < Prints.NUMBERS; number++) {
      int i = Prints.NUMBERS * corner + number;
      double one = seen[i];
      double two = seen[i + next];
      double first = before ? seen[i - next] - 2 * one + two : 0;
      double last = after ? one - 2 * two + seen[i + 2 * next] : 0;
      boolean both = before && after;
      double bend = Math.abs(first + last);
      bends[number] += both ? 0.5 * (bend + STEP * Math.abs(first - last)) : bend;
    }
    return before || after;
  }
}

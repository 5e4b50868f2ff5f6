package glint.image;

import glint.image.Comparison.PixelError;
import java.util.ArrayList;
import java.util.List;

/** The errors of an image in linear light, gathered in one pass in row order. */
final class LinearErrors {

  private static final int WORST = 10;

  /** pbrt's: keeps the relative error of black pixels finite. */
  private static final double MRSE_FLOOR = 0.01;

  private final int count;
  private double squares;
  private double absolutes;
  private double relatives;
  private double max;
  private int invalid;
  private final List<PixelError> worst = new ArrayList<>();

  LinearErrors(ImagePair pair) {
    this.count = 3 * pair.width() * pair.height();
    for (int y = 0; y < pair.height(); y++) {
      for (int x = 0; x < pair.width(); x++) {
        addPixel(pair, x, y);
      }
    }
  }

  double rmse() {
    return Math.sqrt(squares / count);
  }

  double mae() {
    return absolutes / count;
  }

  double mrse() {
    return relatives / count;
  }

  double max() {
    return max;
  }

  int invalid() {
    return invalid;
  }

  List<PixelError> worst() {
    return List.copyOf(worst);
  }

  private void addPixel(ImagePair pair, int x, int y) {
    int at = 3 * (y * pair.width() + x);
    double largest = 0;
    boolean valid = true;
    for (int i = at; i < at + 3; i++) {
      double reference = pair.reference(i);
      double delta = Math.abs(pair.image(i) - reference);
      double relative = delta / (Math.max(reference, 0) + MRSE_FLOOR);
      squares += delta * delta;
      absolutes += delta;
      relatives += relative * relative;
      largest = Math.max(largest, delta);
      valid &= pair.isValid(i);
    }
    max = Math.max(max, largest);
    invalid += valid ? 0 : 1;
    keepIfWorst(x, y, largest);
  }

  private void keepIfWorst(int x, int y, double delta) {
    // Find the place after all that are as bad, so that the first of equals comes first
    int place = worst.size();
    while (place > 0 && worst.get(place - 1).delta() < delta) {
      place--;
    }
    if (place < WORST) {
      worst.add(place, new PixelError(x, y, delta));
      if (worst.size() > WORST) {
        worst.remove(WORST);
      }
    }
  }
}

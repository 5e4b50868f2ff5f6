package glint.render;

import glint.color.Transfer;
import java.util.EnumMap;
import java.util.Map;

/**
 * Display levels by table, for estimates of error: within a hundredth of a level, many times faster
 * than {@link Transfer#level}; immutable.
 */
final class LevelScale {

  /** Steps of the table, even in the square root of the linear value. */
  private static final int STEPS = 1024;

  /** An error that is this share of a value, or less, is so small that the curve is straight. */
  private static final double SMALL = 0x1p-6;

  private static final Map<Transfer, LevelScale> SCALES = new EnumMap<>(Transfer.class);

  static {
    for (Transfer each : Transfer.values()) {
      SCALES.put(each, new LevelScale(each));
    }
  }

  private final double[] levels = new double[STEPS + 2];

  /** How steep the curve is between a step and the next. */
  private final double[] slopes = new double[STEPS + 1];

  /** Returns the table of a curve. */
  static LevelScale of(Transfer transfer) {
    return SCALES.get(transfer);
  }

  private LevelScale(Transfer transfer) {
    for (int i = 0; i < levels.length; i++) {
      double root = (double) i / STEPS;
      levels[i] = transfer.level(root * root);
    }
    for (int i = 0; i < slopes.length; i++) {
      slopes[i] = (levels[i + 1] - levels[i]) / ((2.0 * i + 1) / STEPS / STEPS);
    }
  }

  /** Returns the level of a linear value. */
  double level(double linear) {
    if (!(linear > 0)) {
      return 0;
    }
    double place = STEPS * Math.sqrt(linear < 1 ? linear : 1);
    int i = (int) place;
    return levels[i] + (place - i) * (levels[i + 1] - levels[i]);
  }

  /**
   * Returns a bound on how far a level rises when a linear value does by a little: curves are
   * concave, so none is steeper than its chord over the step before.
   */
  double rise(double linear, double more) {
    if (linear >= 1) {
      return 0;
    }
    int i = Math.max(1, (int) (STEPS * Math.sqrt(Math.max(linear, 0))));
    return more * slopes[i - 1];
  }

  /** Returns the square, in levels², of an error of a linear value, half to either side of it. */
  double squaredError(double linear, double error) {
    double half =
        Math.abs(error) < SMALL * linear && linear < 1 - SMALL
            ? error * slopes[(int) (STEPS * Math.sqrt(linear))]
            : 0.5 * (level(linear + error) - level(linear - error));
    return half * half;
  }

  /** Returns the square of the difference of two linear values, in levels². */
  double squaredDifference(double a, double b) {
    double difference = level(a) - level(b);
    return difference * difference;
  }
}

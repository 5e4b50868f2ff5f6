package glint.verify;

import glint.geometry.Surface;
import glint.math.Rounding;
import glint.math.Vector3d;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Draws surfaces of one kind, and rays that are hard to decide about them.
 *
 * @param name the kind
 * @param shape draws a surface
 * @param oracle knows the truth about it
 * @param spot draws a line that touches it or nearly so
 * @param decision the derived band within which a hit or miss may be decided either way
 * @param parameter the derived bound of the error of t
 */
record Adversary<S extends Surface>(
    String name,
    Function<Dice, S> shape,
    Function<S, Oracle> oracle,
    BiFunction<Dice, S, Spot> spot,
    Bound decision,
    Bound parameter) {

  /** Rays at each surface, before the next is drawn. */
  private static final int RAYS = 8;

  /** A point on a surface, a unit direction through it, and the surface's size. */
  record Spot(Vector3d point, Vector3d direction, double size) {}

  /**
   * Draws rays at surfaces.
   *
   * @param range takes each surface, and then the rays at it: origin and direction
   */
  void attack(Dice dice, int rays, Function<S, BiConsumer<Vector3d, Vector3d>> range) {
    for (int i = 0; i < rays; i += RAYS) {
      S surface = shape.apply(dice);
      BiConsumer<Vector3d, Vector3d> target = range.apply(surface);
      for (int k = 0; k < RAYS; k++) {
        Spot at = spot.apply(dice, surface);
        double distance = at.size * dice.log(1e-6, 1e10);
        Vector3d nudge = dice.across(at.direction).times(nudge(dice) * (distance + at.size));
        Vector3d o = at.point.minus(at.direction.times(distance));
        Vector3d aimed = at.point.plus(nudge).minus(o);
        Vector3d along = at.direction;
        if (dice.below(2) == 0) {
          o = o.plus(nudge);
          aimed = along;
        }
        target.accept(o, aimed.maxAbs() > 0 ? aimed.times(stretch(dice)) : along);
      }
    }
  }

  /** How far aside to aim, as a share of distance plus size: nothing, roundings, or more. */
  private static double nudge(Dice dice) {
    return switch (dice.below(4)) {
      case 0 -> 0;
      case 1 -> dice.log(0.1, 100) * Rounding.U;
      case 2 -> dice.log(1e-15, 1e-9);
      default -> dice.log(1e-9, 0.5);
    };
  }

  /** The length of a direction: a power of two, or anything. */
  private static double stretch(Dice dice) {
    return dice.below(2) == 0 ? dice.power(40) : dice.log(1e-9, 1e9);
  }
}

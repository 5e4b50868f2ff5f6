package glint.verify;

import glint.geometry.Surface;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Random rays that are hard to decide, against exact arithmetic: two rows a kind of primitive.
 *
 * <p>A hit or miss may be wrong only where the ray passes an edge or silhouette within a band
 * proportional to u·S, S = distance + size; every oracle derives its own.
 */
final class AdversarialCases {

  private static final int LITTLE = 20_000;
  private static final int MUCH = 1_000_000;

  private AdversarialCases() {}

  static List<HardCase> all() {
    List<HardCase> cases = new ArrayList<>();
    for (Adversary<?> adversary : Adversaries.ALL) {
      cases.add(
          HardCase.within(
              "ADV-" + adversary.name(),
              "adversarial rays: a wrong hit or miss is this near an edge or silhouette",
              adversary.decision(),
              tally -> decide(adversary, tally)));
      cases.add(
          HardCase.within(
              "ADV-" + adversary.name() + "-t",
              "adversarial rays: error of t",
              adversary.parameter(),
              tally -> measure(adversary, tally)));
    }
    cases.add(HardCase.exact("ADV-tree", "adversarial rays: tree = scan", AdversarialCases::climb));
    return cases;
  }

  private static <S extends Surface> void decide(Adversary<S> adversary, Tally tally) {
    double bound = adversary.parameter().most();
    adversary.attack(
        new Dice(1),
        tally.times(LITTLE, MUCH),
        surface -> {
          Shoot shoot = Shoot.at(surface);
          Oracle oracle = adversary.oracle().apply(surface);
          return (o, d) -> {
            boolean found = shoot.from(o, d);
            double t = shoot.hit.t;
            double off = found ? oracle.off(o, d, t) : 0;
            double wrong = Crossing.wrongness(oracle.crossings(o, d), found, t, bound, off);
            tally.check(wrong <= adversary.decision().most());
            tally.error(wrong);
          };
        });
  }

  private static <S extends Surface> void measure(Adversary<S> adversary, Tally tally) {
    adversary.attack(
        new Dice(2),
        tally.times(LITTLE / 2, MUCH),
        surface -> {
          Shoot shoot = Shoot.at(surface);
          Oracle oracle = adversary.oracle().apply(surface);
          return (o, d) -> {
            if (shoot.from(o, d)) {
              double error = Crossing.error(oracle.crossings(o, d), shoot.hit.t);
              tally.check(error <= adversary.parameter().most());
              tally.error(error);
            }
          };
        });
  }

  /** Eight copies need a tree, whose boxes are no wider than the surface asks for. */
  private static void climb(Tally tally) {
    for (Adversary<?> adversary : Adversaries.ALL) {
      adversary.attack(
          new Dice(3),
          tally.times(LITTLE, MUCH),
          surface -> {
            Soup soup = new Soup(Shoot.primitives(Collections.nCopies(8, surface)));
            return (o, d) -> tally.check(soup.agrees(o, d));
          });
    }
  }
}

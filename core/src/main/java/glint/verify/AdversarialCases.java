package glint.verify;

import java.util.ArrayList;
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
    return cases;
  }

  private static void decide(Adversary<?> adversary, Tally tally) {
    adversary.attack(
        new Dice(1),
        tally.times(LITTLE, MUCH),
        (oracle, shoot, o, d) -> {
          double wrong =
              Crossing.wrongness(
                  oracle.crossings(o, d),
                  shoot.hit.found(),
                  shoot.hit.t,
                  adversary.parameter().most());
          tally.check(wrong <= adversary.decision().most());
          tally.error(wrong);
        });
  }

  private static void measure(Adversary<?> adversary, Tally tally) {
    adversary.attack(
        new Dice(2),
        tally.times(LITTLE / 2, MUCH),
        (oracle, shoot, o, d) -> {
          if (shoot.hit.found()) {
            double error = Crossing.error(oracle.crossings(o, d), shoot.hit.t);
            tally.check(error <= adversary.parameter().most());
            tally.error(error);
          }
        });
  }
}

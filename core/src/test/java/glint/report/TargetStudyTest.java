package glint.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Transfer;
import glint.image.Image;
import glint.render.Aov;
import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Statistics;
import glint.trace.RayCounts;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Studies of a renderer that errs by rule: pixel i by i/8 of the target, claimed 0.8 of it. */
class TargetStudyTest {

  private static final RenderSettings SETTINGS =
      new RenderSettings(4, 3, 1, 5, OptionalInt.empty(), 1, 8, Set.of());

  private final Image truth = new Image(4, 3);

  private RenderResult render(RenderSettings settings) {
    double target = settings.goal() instanceof Goal.Error error ? error.levels() : 0;
    Image image = new Image(4, 3);
    Image claims = new Image(4, 3);
    for (int i = 0; i < 12; i++) {
      double off = i * target / 8;
      image.set(i % 4, i / 4, off / 255, off / 255, off / 255);
      claims.set(i % 4, i / 4, 0.5 * i, 0, 0);
    }
    Map<Aov, Image> aovs = new EnumMap<>(Aov.class);
    for (Aov aov : settings.aovs()) {
      aovs.put(aov, claims);
    }
    RayCounts rays = new RayCounts();
    rays.camera = 12;
    rays.maxDepth = settings.maxDepth().orElse(5);
    double cut = 4.0 / (1 + rays.maxDepth);
    Statistics s =
        new Statistics(
            rays, 1, 1.5, 2, 1, 0, 0, -1, 0, 0.75 * target, cut, 1e-3 * (1 + rays.maxDepth));
    return new RenderResult(image, aovs, s);
  }

  @Test
  void claimsStandBesideTheTruth() {
    Reference reference = new Reference(truth, "black", 0, Transfer.LINEAR);
    TargetStudy study = TargetStudy.of(this::render, SETTINGS, reference);
    assertEquals(4, study.runs().size());
    TargetRuns two = study.runs().get(1);
    assertEquals(2, two.target());
    assertEquals(TargetStudy.RUNS, two.claims().size());
    // The mean of the squares from 0 to 11 is 506/12.
    double actual = 2 * Math.sqrt(506 / 12.0) / 8;
    assertEquals(actual, two.error().levels(), 1e-12);
    assertEquals(
        new Honesty.Claim(2, 1.5 + 4 / 6.0, actual).claimed(), two.claims().get(0).claimed());
    assertEquals(10, study.worst().size());
    TargetStudy.Worst worst = study.worst().get(0);
    assertEquals(3, worst.x());
    assertEquals(2, worst.y());
    assertEquals(11 / 8.0, worst.actual(), 1e-12);
    assertEquals(5.5, worst.claimed());
    assertEquals(5, worst.samples());
    assertTrue(study.worst().get(9).actual() < study.worst().get(8).actual());
  }

  @Test
  void bouncesAreDoubledUpToThoseThatThereAre() {
    Reference reference = new Reference(truth, "black", 0, Transfer.LINEAR);
    DepthStudy study = DepthStudy.of(this::render, SETTINGS, reference);
    assertEquals(
        List.of(0, 1, 2, 4, 5), study.points().stream().map(DepthStudy.Point::depth).toList());
    DepthStudy.Point one = study.points().get(1);
    assertEquals(2, one.bound());
    assertEquals(2e-3, one.seconds(), 1e-12);
    assertEquals(0, one.error());
  }
}

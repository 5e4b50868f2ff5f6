package glint.report;

import glint.image.Image;
import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Statistics;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * What bounces cost and bring: images of the same samples with fewer of them.
 *
 * @param points by growing depth; the last one follows all bounces
 */
public record DepthStudy(List<Point> points) {

  /** Samples of a pixel: what is compared shares them, so that few are enough. */
  private static final int SAMPLES = 4;

  /** Images of each depth, by turns, of which the fastest counts. */
  private static final int RUNS = 5;

  /**
   * A limit of bounces.
   *
   * @param depth the most successive bounces
   * @param error how far the image is from that of all bounces, in display levels
   * @param bound what it says that it may be, in display levels
   * @param seconds of tracing
   * @param rays of all kinds
   */
  public record Point(int depth, double error, double bound, double seconds, long rays) {}

  /** Renders with 0, 1, 2, 4, 8 … bounces, up to those that the scene has. */
  public static DepthStudy of(Study.Render render, RenderSettings settings, Reference truth) {
    Goal goal = new Goal.Samples(SAMPLES);
    RenderSettings free = settings.aiming(goal, settings.seed(), Set.of());
    int deepest = render.render(free).statistics().rays().maxDepth;
    Image all = render.render(free.atDepth(deepest)).image();
    List<Integer> depths = new ArrayList<>();
    for (int depth = 0; depth < deepest; depth = depth == 0 ? 1 : 2 * depth) {
      depths.add(depth);
    }
    depths.add(deepest);
    Point[] points = new Point[depths.size()];
    for (int run = 0; run < RUNS; run++) {
      for (int i = 0; i < points.length; i++) {
        RenderResult result = render.render(free.atDepth(depths.get(i)));
        Statistics s = result.statistics();
        double before = run == 0 ? s.renderSeconds() : points[i].seconds;
        points[i] =
            new Point(
                depths.get(i),
                Errors.between(result.image(), all, truth.transfer()).levels(),
                s.truncation(),
                Math.min(before, s.renderSeconds()),
                s.rays().total());
      }
    }
    return new DepthStudy(List.of(points));
  }
}

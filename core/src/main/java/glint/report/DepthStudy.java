package glint.report;

import glint.image.Image;
import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
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

  /** Images of which the fastest counts. */
  private static final int RUNS = 3;

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
    List<Point> points = new ArrayList<>();
    for (int depth = 0; depth < deepest; depth = depth == 0 ? 1 : 2 * depth) {
      points.add(point(render, free, depth, all, truth));
    }
    points.add(point(render, free, deepest, all, truth));
    return new DepthStudy(List.copyOf(points));
  }

  private static Point point(
      Study.Render render, RenderSettings free, int depth, Image all, Reference truth) {
    RenderResult result = null;
    double seconds = Double.POSITIVE_INFINITY;
    for (int run = 0; run < RUNS; run++) {
      result = render.render(free.atDepth(depth));
      seconds = Math.min(seconds, result.statistics().renderSeconds());
    }
    double error = Errors.between(result.image(), all, truth.transfer()).levels();
    double bound = result.statistics().truncation();
    return new Point(depth, error, bound, seconds, result.statistics().rays().total());
  }
}

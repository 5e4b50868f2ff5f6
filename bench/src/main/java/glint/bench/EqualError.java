package glint.bench;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;

/** What an error costs, from settings of a renderer that were measured. */
final class EqualError {

  /**
   * A setting that was measured.
   *
   * @param levels its true error, more than 0
   * @param seconds what it took, more than 0
   */
  record Point(String setting, double levels, double seconds) {}

  private EqualError() {}

  /** Returns those that no other beats in both error and time, the fastest first. */
  static List<Point> best(List<Point> points) {
    List<Point> sorted = new ArrayList<>(points);
    sorted.sort(Comparator.comparingDouble(Point::seconds).thenComparingDouble(Point::levels));
    List<Point> best = new ArrayList<>();
    for (Point point : sorted) {
      if (best.isEmpty() || point.levels < best.get(best.size() - 1).levels) {
        best.add(point);
      }
    }
    return best;
  }

  /**
   * Returns the seconds to an error: by a power law between the two best settings around it, and
   * those of the fastest where that is as good.
   *
   * @return nothing if no setting reaches it
   */
  static OptionalDouble seconds(List<Point> points, double levels) {
    Point before = null;
    for (Point point : best(points)) {
      if (point.levels <= levels) {
        return OptionalDouble.of(before == null ? point.seconds : between(before, point, levels));
      }
      before = point;
    }
    return OptionalDouble.empty();
  }

  private static double between(Point before, Point after, double levels) {
    double share = Math.log(before.levels / levels) / Math.log(before.levels / after.levels);
    return before.seconds * Math.pow(after.seconds / before.seconds, share);
  }
}

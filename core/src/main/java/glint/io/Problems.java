package glint.io;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Collects the problems of one file; the same problem at the same place counts as one. */
final class Problems {

  /** How many problems of a scene file are told; beyond, only their number is. */
  static final int MOST = 100;

  /** How many times more problems are looked for. */
  private static final int SOUGHT = 100;

  private static final int LONGEST = 400;

  private final String file;
  private final int most;
  private final Set<Problem> problems = new LinkedHashSet<>();
  private long reports;
  private int written;

  Problems(String file) {
    this(file, MOST);
  }

  /** Tells at most so many. */
  Problems(String file, int most) {
    this.file = file;
    this.most = most;
  }

  /**
   * Reports a problem.
   *
   * @throws TooMany if there have been so many that there is no use in reading on
   */
  void report(Place place, String message) {
    String line = message.replaceAll("[\\p{Cntrl}\u0085\u2028\u2029]+", " ");
    boolean whole = line.length() <= LONGEST;
    problems.add(
        new Problem(
            file, place.line(), place.column(), whole ? line : line.substring(0, LONGEST) + "…"));
    reports++;
    written++;
    if (written == SOUGHT * most) {
      throw new TooMany();
    }
  }

  /** Returns whether another report is not one too many. */
  boolean takesMore() {
    return written < SOUGHT * most - 1;
  }

  /** Counts a problem that was reported before and now concerns something else as well. */
  void repeat() {
    reports++;
  }

  /** Returns a number that grows with every report: whoever sees it unchanged read well. */
  long reports() {
    return reports;
  }

  /** What concerns the file as a whole comes last. */
  private static int order(Problem problem) {
    return problem.line() == 0 ? Integer.MAX_VALUE : problem.line();
  }

  /** Returns the problems in file order, at most so many as are told and a closing line. */
  List<Problem> inFileOrder() {
    List<Problem> sorted = new ArrayList<>(problems);
    sorted.sort(Comparator.comparingInt(Problems::order).thenComparingInt(Problem::column));
    if (sorted.size() <= most) {
      return sorted;
    }
    List<Problem> first = new ArrayList<>(sorted.subList(0, most));
    int more = sorted.size() - most;
    String end = written == SOUGHT * most ? "; reading ended there" : "";
    first.add(new Problem(file, 0, 0, "and " + more + " more problems, not shown" + end));
    return first;
  }

  /** Ends the reading of a file that is wrong in too many places. */
  static final class TooMany extends RuntimeException {
    private static final long serialVersionUID = 1;
  }
}

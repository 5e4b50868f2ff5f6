package glint.bench;

import java.io.IOException;

/** Something that finds what rays hit. */
public interface Kernel {

  /**
   * What tracing took.
   *
   * @param seconds of CPU time
   * @param hits how many rays hit something
   */
  record Took(double seconds, int hits) {}

  /** What it is called. */
  String name();

  /** Traces rays, all on one thread. */
  Took trace(Rays rays) throws IOException;
}

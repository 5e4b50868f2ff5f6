package glint.bench;

import glint.image.Image;
import java.io.IOException;
import java.util.List;

/** A renderer with one scene, and the settings of its antialiasing that are tried. */
interface Peer {

  /**
   * What a render gave.
   *
   * @param image linear
   * @param seconds of CPU time, of tracing alone
   */
  record Run(Image image, double seconds) {}

  /** Returns what it is called. */
  String name();

  /** Returns the settings that are tried, the fast ones first. */
  List<String> settings();

  /** Returns whether it is compiled while it runs, and faster after a while. */
  boolean warms();

  /** Renders on one thread. */
  Run render(String setting) throws IOException;

  /**
   * Returns what its images should be: a long run of its own.
   *
   * @param fine a power of two; so many by so many rays are traced in every pixel
   */
  Image reference(int fine) throws IOException;
}

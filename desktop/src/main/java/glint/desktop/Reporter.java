package glint.desktop;

import glint.render.Progress;
import java.io.PrintWriter;
import java.util.stream.Collectors;

/** Tells whoever started a batch how it goes: bars on a terminal, else one line per scene. */
final class Reporter implements AutoCloseable {

  private final PrintWriter err;
  private final boolean quiet;
  private final boolean bars;
  private Bar bar;

  /** Reports to {@code err}; if quiet, errors only. */
  Reporter(PrintWriter err, boolean quiet) {
    this.err = err;
    this.quiet = quiet;
    this.bars = !quiet && Terminal.isWatched();
  }

  /** Returns where the lines go. */
  PrintWriter err() {
    return err;
  }

  /** Prints an error. */
  void error(String line) {
    close();
    err.println(line);
  }

  /** Prints what is worth knowing, unless quiet. */
  void note(String line) {
    if (!quiet) {
      close();
      err.println(line);
    }
  }

  /** Begins a scene; returns what the renderer shall tell about it. */
  Progress begin(String scene) {
    if (!bars) {
      return Progress.NONE;
    }
    bar = new Bar(scene);
    return bar;
  }

  /** Ends a scene that is rendered and written. */
  void finished(SceneStats s, int samples, OutputFiles files) {
    String rate = Figures.rate(s.rays().total(), s.seconds().render());
    String where = " -> " + names(files);
    if (bar != null) {
      bar.finish(rate + where);
      close();
    } else {
      note(
          String.format(
              "%s: %dx%d, %s, %s, %s%s",
              s.name(),
              s.width(),
              s.height(),
              Figures.count(samples, "sample"),
              Figures.seconds(s.seconds().render()),
              rate,
              where));
    }
    if (s.invalid() != 0) {
      note(
          s.name()
              + ": warning: "
              + Figures.count((int) Math.min(s.invalid(), Integer.MAX_VALUE), "sample")
              + " not finite (NaN or infinite) and left out");
    }
  }

  /** Ends a scene whose files are there already. */
  void kept(SceneStats s, OutputFiles files) {
    String doubt = files.png().isPresent() ? "" : " (a PFM holds no record of its options)";
    note(s.name() + ": kept " + names(files) + doubt);
  }

  /** Ends the line of a bar, if there is one. */
  @Override
  public void close() {
    if (bar != null) {
      bar.close();
      bar = null;
    }
  }

  private static String names(OutputFiles files) {
    return files.all().stream().map(Object::toString).collect(Collectors.joining(", "));
  }
}

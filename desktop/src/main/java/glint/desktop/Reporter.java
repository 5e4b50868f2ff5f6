package glint.desktop;

import glint.render.Progress;
import java.io.PrintWriter;
import java.util.Locale;
import java.util.stream.Collectors;

/** Tells whoever started a batch how it goes: bars on a terminal, else one line per scene. */
final class Reporter implements AutoCloseable {

  /** The share of the error by sampling from which that by truncation is told as well. */
  private static final double TOLD = 0.2;

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
  void finished(SceneStats s, OutputFiles files) {
    double seconds = s.seconds().render();
    String end = Figures.rate(s.rays().total(), seconds) + " -> " + names(files);
    if (bar != null) {
      bar.finish(quality(s) + ", " + end);
      close();
    } else {
      String what = s.width() + "x" + s.height() + ", " + quality(s);
      note(s.name() + ": " + what + ", " + Figures.seconds(seconds) + ", " + end);
    }
    if (s.invalid() != 0) {
      String count = Figures.count(s.invalid(), "sample");
      note(s.name() + ": warning: " + count + " not finite (NaN or infinite) and left out");
    }
  }

  /** Returns how many samples a pixel took, and what error that has left. */
  private static String quality(SceneStats s) {
    SceneStats.Samples samples = s.samples();
    SceneStats.ErrorEstimate error = s.error();
    double sampling = error.estimate() - error.truncation();
    String line =
        (samples.min() == samples.max()
                ? Figures.count(samples.min(), "sample")
                : String.format(Locale.ROOT, "%.1f samples", samples.mean()))
            + String.format(Locale.ROOT, ", error %.2g levels", sampling);
    boolean more = error.truncation() > TOLD * sampling;
    return more
        ? line + String.format(Locale.ROOT, " and up to %.2g of light cut off", error.truncation())
        : line;
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

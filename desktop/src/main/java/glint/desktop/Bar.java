package glint.desktop;

import glint.render.Progress;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** The progress of one scene on a terminal: tiles, rays per second, time left. */
final class Bar implements Progress, AutoCloseable {

  private static final int REDRAW_MILLIS = 100;

  private final ProgressBar bar;
  private final long began = System.nanoTime();

  /** Draws an empty bar on standard error. */
  Bar(String scene) {
    PrintStream err =
        new PrintStream(new FileOutputStream(FileDescriptor.err), true, StandardCharsets.UTF_8);
    bar =
        new ProgressBarBuilder()
            .setTaskName(scene)
            .setStyle(ProgressBarStyle.ASCII)
            .setUnit(" tiles", 1)
            .hideEta()
            .setUpdateIntervalMillis(REDRAW_MILLIS)
            .setConsumer(new ConsoleProgressBarConsumer(err))
            .build();
  }

  @Override
  public void tileDone(int done, int total, long rays) {
    double seconds = (System.nanoTime() - began) * 1e-9;
    String left = Figures.clock(seconds / done * (total - done));
    bar.maxHint(total);
    bar.stepTo(done);
    bar.setExtraMessage(" " + Figures.rate(rays, seconds) + ", " + left + " left");
  }

  /** Replaces the time left, of which there is none, by a last word. */
  void finish(String message) {
    bar.setExtraMessage(" " + message);
  }

  /** Draws the bar for the last time and ends its line. */
  @Override
  public void close() {
    bar.close();
  }
}

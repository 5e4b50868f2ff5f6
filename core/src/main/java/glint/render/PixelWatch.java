package glint.render;

import glint.trace.Recorder;
import java.util.ArrayList;
import java.util.List;

/** Writes down every camera ray through one pixel, or along its border, while an image is made. */
final class PixelWatch {

  private final int column;
  private final int row;

  /** Is told of every ray of the image. */
  final Recorder recorder = new Recorder();

  final List<Replay.Sample> seen = new ArrayList<>();

  PixelWatch(int column, int row) {
    this.column = column;
    this.row = row;
  }

  /** A camera ray through a place of the image has been traced. */
  void saw(double x, double y) {
    double u = x - column;
    double v = y - row;
    if (u >= 0 && u <= 1 && v >= 0 && v <= 1) {
      seen.add(new Replay.Sample(seen.size(), u, v, recorder.tree()));
    }
  }
}

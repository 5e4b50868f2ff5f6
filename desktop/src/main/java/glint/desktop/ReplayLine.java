package glint.desktop;

import glint.render.RenderSettings;
import glint.scene.Scene;
import java.nio.file.Path;

/** The command that shows how a pixel came about, for whatever reports one. */
final class ReplayLine {

  private ReplayLine() {}

  /** Returns the command, ready for a shell, that traces a pixel again as settings say. */
  static String of(Path file, Scene scene, RenderSettings settings, int column, int row) {
    StringBuilder line = new StringBuilder("glint replay ");
    line.append(quote(file.toString())).append(" --scene ").append(quote(scene.name()));
    line.append(" --pixel ").append(column).append(',').append(row);
    if (settings.width() != scene.width() || settings.height() != scene.height()) {
      line.append(" --size ").append(settings.width()).append('x').append(settings.height());
    }
    if (settings.samples() != RenderSettings.DEFAULT_SAMPLES) {
      line.append(" --samples ").append(settings.samples());
    }
    if (settings.seed() != 0) {
      line.append(" --seed ").append(settings.seed());
    }
    settings.maxDepth().ifPresent(depth -> line.append(" --depth ").append(depth));
    return line.toString();
  }

  private static String quote(String word) {
    return word.matches("[\\w./+-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}

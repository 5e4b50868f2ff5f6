package glint.desktop;

import glint.render.Goal;
import glint.render.RenderSettings;
import glint.scene.Scene;
import java.math.BigDecimal;
import java.nio.file.Path;

/** The commands, ready for a shell, that show again what a report is about. */
final class SeeAgain {

  private SeeAgain() {}

  /** Returns the command that traces a pixel as settings say. */
  static String pixel(Path file, Scene scene, RenderSettings settings, int column, int row) {
    String pixel = " --pixel " + column + "," + row;
    return "glint replay " + of(file, scene) + pixel + options(scene, settings);
  }

  /** Returns the command that renders an image as settings say. */
  static String image(Path file, Scene scene, RenderSettings settings) {
    return "glint render " + of(file, scene) + options(scene, settings);
  }

  private static String of(Path file, Scene scene) {
    return quote(file.toString()) + " --scene " + quote(scene.name());
  }

  private static String options(Scene scene, RenderSettings settings) {
    StringBuilder options = new StringBuilder();
    if (settings.width() != scene.width() || settings.height() != scene.height()) {
      options.append(" --size ").append(settings.width()).append('x').append(settings.height());
    }
    if (settings.goal() instanceof Goal.Samples exactly
        && exactly.count() != RenderSettings.DEFAULT_SAMPLES) {
      options.append(" --samples ").append(exactly.count());
    }
    if (settings.goal() instanceof Goal.Error error && error.levels() > 0) {
      BigDecimal levels = new BigDecimal(String.valueOf(error.levels())).stripTrailingZeros();
      options.append(" --max-error ").append(levels.toPlainString());
    }
    if (settings.seed() != 0) {
      options.append(" --seed ").append(settings.seed());
    }
    settings.maxDepth().ifPresent(depth -> options.append(" --depth ").append(depth));
    return options.toString();
  }

  private static String quote(String word) {
    return word.matches("[\\p{L}\\p{Nd}_./+-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}

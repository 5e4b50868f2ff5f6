package glint.desktop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Scene files for tests. */
final class Scenes {

  private static final String SHARED =
      """
      materials:
        mirror: {reflection: 0.8, diffuse: 0.1}
        gold: {color: [1, 0.7, 0], diffuse: 0.5, specular: 0.4, reflection: 0.1}
      defaults:
        image: {width: 40, height: 30}
        camera: {position: [0, 2, 8], look_at: [0, 1, 0], up: [0, 1, 0], fov: 40}
        background: [0.1, 0.1, 0.15]
        lights:
          - ambient: {color: 0.1}
          - point: {position: [5, 8, 5], color: 1}
      scenes:
      """;

  private Scenes() {}

  /**
   * Writes a YAML file with a mirror ball on a golden floor for each name, each a bit different.
   */
  static Path write(Path file, String... names) throws IOException {
    StringBuilder text = new StringBuilder(SHARED);
    double x = 0;
    for (String name : names) {
      text.append("  ").append(name).append(":\n    surfaces:\n");
      text.append("      - sphere: {center: [" + x + ", 1, 0], radius: 1, material: mirror}\n");
      text.append("      - plane: {point: [0, 0, 0], normal: [0, 1, 0], material: gold}\n");
      x += 0.125;
    }
    return Files.writeString(file, text);
  }
}

package glint.bench;

import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;

/** Reading and rendering, as far as measurements need it. */
final class Scenes {

  private Scenes() {}

  /**
   * Reads a scene file, and models and images beside it.
   *
   * @throws IOException if anything is wrong with it
   */
  static List<Scene> read(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      Path folder = file.toAbsolutePath().getParent();
      return scenes(SceneFiles.read(in, file.toString(), new SceneFolderHere(folder)));
    }
  }

  /** Returns the one scene that a text in YAML holds. */
  static Scene parse(String yaml) throws IOException {
    InputStream in = new ByteArrayInputStream(yaml.getBytes(StandardCharsets.UTF_8));
    return scenes(SceneFiles.read(in, "scene.yaml", path -> InputStream.nullInputStream())).get(0);
  }

  private static List<Scene> scenes(SceneFile file) throws IOException {
    if (!file.problems().isEmpty()) {
      throw new IOException(file.problems().get(0).toString());
    }
    return file.scenes();
  }

  /** Renders a scene in its own size on one thread, one ray through the centre of every pixel. */
  static RenderResult render(Scene scene) {
    RenderSettings settings =
        new RenderSettings(
            scene.width(), scene.height(), 1, 0, OptionalInt.empty(), 1, 32, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }
}

package glint.scenes;

import glint.image.Image;
import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The scene files of this repository, and small renders of them. */
final class Repository {

  private Repository() {}

  /** Returns the folder that holds settings.gradle: Gradle runs tests in the module's. */
  static Path root() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("settings.gradle"))) {
      folder = folder.getParent();
    }
    return folder;
  }

  /** Returns every file that Glint brings scenes in. */
  static List<Path> sceneFiles() {
    Path scenes = root().resolve("scenes");
    try (Stream<Path> course = Files.list(scenes.resolve("cs315"))) {
      Stream<Path> own = Stream.of("gallery.yaml", "stories.yaml").map(scenes::resolve);
      return Stream.concat(own, course.sorted()).collect(Collectors.toList());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static SceneFile read(Path file) {
    try (InputStream in = Files.newInputStream(file)) {
      return SceneFiles.read(in, file.getFileName().toString(), new FilesBeside(file));
    } catch (IOException e) {
      throw new UncheckedIOException(file.toString(), e);
    }
  }

  /** Renders one sample a pixel, through its centre. */
  static RenderResult render(Scene scene, int width, int height) {
    RenderSettings settings =
        new RenderSettings(
            width, height, 1, 0, OptionalInt.empty(), 1, RenderSettings.DEFAULT_TILE, Set.of());
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** Returns whether all pixels of an image are the same. */
  static boolean isFlat(Image image) {
    double[] rgb = image.rgb();
    for (int i = 3; i < rgb.length; i++) {
      if (rgb[i] != rgb[i - 3]) {
        return false;
      }
    }
    return true;
  }
}

package glint.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Locale;

/** Reads scene files of every format that Glint knows; the door of this package. */
public final class SceneFiles {

  private SceneFiles() {}

  /**
   * Reads the scenes of one file: YAML (docs/scene-format.md) if its name ends in .yaml or .yml,
   * the CS 315 format if it ends in .txt; a model, which becomes a scene, if it ends in .obj.
   *
   * <p>Whatever is wrong with the content becomes a problem and never an exception; scenes without
   * a problem are read all the same, unless the file has 10 000 problems or more.
   *
   * @param in the bytes; left open
   * @param fileName the file's name or path, which also begins every message
   * @param folder opens the models and materials that the file names
   * @throws IOException if the stream fails
   */
  public static SceneFile read(InputStream in, String fileName, SceneFolder folder)
      throws IOException {
    String name = fileName.toLowerCase(Locale.ROOT);
    if (name.endsWith(".obj")) {
      return ObjScene.read(in, fileName, folder);
    }
    Problems problems = new Problems(fileName);
    boolean yaml = name.endsWith(".yaml") || name.endsWith(".yml");
    if (!yaml && !name.endsWith(".txt")) {
      problems.report(
          Place.NONE,
          "unknown kind of file: scene files end in .yaml or .yml, or in .txt if they are in the CS"
              + " 315 format; models end in .obj");
      return nothing(problems);
    }
    String text = SourceText.read(in, problems);
    if (text == null) {
      return nothing(problems);
    }
    try {
      return yaml
          ? new SceneFileReader(folder, fileName, problems).read(text)
          : new Cs315Reader(fileName, problems).read(text);
    } catch (Problems.TooMany e) {
      return nothing(problems);
    }
  }

  private static SceneFile nothing(Problems problems) {
    return new SceneFile(List.of(), List.of(), problems.inFileOrder(), List.of());
  }
}

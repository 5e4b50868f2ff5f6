package glint.io;

import glint.image.ByteImage;
import glint.image.Noise;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What the tests of the readers read. */
final class Resources {

  /** What {@code @scene} stands for in bad-yaml.txt. */
  private static final String SCENE =
      """
      scenes:
        s:
          camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
      """;

  /** What {@code @head} stands for in bad-cs315.txt. */
  private static final String HEAD =
      """
      Camera 0 0 5  0 1 0  0 0 0  40 1
      Output 100 100 s.png
      """;

  /** The models beside the test's files; every image is the same. */
  static final SceneFolder MODELS =
      new SceneFolder() {
        @Override
        public InputStream open(String path) throws IOException {
          InputStream in = Resources.class.getResourceAsStream(path);
          if (in == null && !path.endsWith(".png")) {
            throw new IOException("no such file");
          }
          return in == null ? InputStream.nullInputStream() : in;
        }

        @Override
        public ByteImage decode(InputStream in, Consumer<String> remarks) {
          return Noise.of(5, 3);
        }
      };

  private Resources() {}

  /**
   * A scene file that is wrong.
   *
   * @param kind structure, meaning or yaml: who can see what is wrong
   * @param answers what must be said of it, and {@code scene NAME} for the scenes that remain
   */
  record Bad(String kind, String name, String text, List<String> answers) {
    @Override
    public String toString() {
      return name;
    }
  }

  /** Returns the cases of a file: {@code === name}, the text, {@code > answer}. */
  static List<Bad> bad(String resource) {
    List<Bad> cases = new ArrayList<>();
    for (String part : text(resource).split("(?m)^=== ")) {
      if (part.isEmpty()) {
        continue;
      }
      String[] lines = part.split("\n");
      StringBuilder text = new StringBuilder();
      List<String> answers = new ArrayList<>();
      for (int i = 1; i < lines.length; i++) {
        if (lines[i].startsWith("> ")) {
          answers.add(lines[i].substring(2));
        } else {
          text.append(lines[i]).append('\n');
        }
      }
      String source = text.toString().replace("@scene\n", SCENE).replace("@head\n", HEAD);
      int colon = lines[0].indexOf(": ");
      String kind = colon < 0 ? "" : lines[0].substring(0, colon);
      cases.add(new Bad(kind, lines[0], source.replace('→', '\t'), answers));
    }
    return cases;
  }

  static String text(String resource) {
    try (InputStream in = Resources.class.getResourceAsStream(resource)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new AssertionError(resource, e);
    }
  }

  /** Returns a file of this repository as text. */
  static String repositoryText(String path) {
    try {
      return Files.readString(repository().resolve(path), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new AssertionError(path, e);
    }
  }

  static Path repository() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("settings.gradle"))) {
      folder = folder.getParent();
    }
    return folder;
  }

  /** Returns the files under scenes/ whose names end so. */
  static List<Path> scenes(String ending) throws IOException {
    try (Stream<Path> files = Files.walk(repository().resolve("scenes"))) {
      return files
          .filter(file -> file.toString().endsWith(ending))
          .sorted()
          .collect(Collectors.toList());
    }
  }

  static SceneFile read(String text, String fileName) {
    return read(text.getBytes(StandardCharsets.UTF_8), fileName);
  }

  /** Reads a file of this repository, with the models that it names. */
  static SceneFile read(Path file) throws IOException {
    SceneFolder folder = path -> Files.newInputStream(file.resolveSibling(path));
    return read(Files.readAllBytes(file), file.toString(), folder);
  }

  static SceneFile read(byte[] bytes, String fileName) {
    return read(bytes, fileName, MODELS);
  }

  static SceneFile read(byte[] bytes, String fileName, SceneFolder folder) {
    try {
      return SceneFiles.read(new ByteArrayInputStream(bytes), fileName, folder);
    } catch (IOException e) {
      throw new AssertionError(fileName, e);
    }
  }

  /** Returns what a reader answers, in the form of the files of bad cases. */
  static List<String> answers(SceneFile file, String fileName) {
    List<String> answers = new ArrayList<>();
    file.problems().forEach(p -> answers.add(p.toString().substring(fileName.length())));
    file.notes().forEach(p -> answers.add("note " + p.toString().substring(fileName.length())));
    file.scenes().forEach(scene -> answers.add("scene " + scene.name()));
    return answers;
  }
}

package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Plane;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.NamedMaterial;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** docs/scene-format.md tells the truth. */
class SceneFormatDocTest {

  private static final String DOC = Resources.repositoryText("docs/scene-format.md");

  /** Returns the example that the page begins with. */
  static String example() {
    return between("```yaml\n", "```");
  }

  private static String between(String begin, String end) {
    int from = DOC.indexOf(begin) + begin.length();
    return DOC.substring(from, DOC.indexOf(end, from));
  }

  @Test
  void theExampleIsReadAsThePageSays() {
    SceneFile file = Resources.read(example(), "doc.yaml");
    assertEquals(List.of(), file.problems());
    Scene first = file.scenes().get(0);
    assertEquals("mirror-on-gold", first.name());
    assertEquals("A mirror ball on a gold floor", first.title());
    assertEquals(2, first.lights().size());
    assertEquals(
        new Placement(
            new Plane(Vector3d.ZERO, new Vector3d(0, 1, 0)),
            Transform.IDENTITY,
            List.of(
                new NamedMaterial(
                    "gold",
                    new Material(
                        new Rgb(0.5, 0.35, 0),
                        new Rgb(0.5, 0.35, 0),
                        Rgb.grey(0.4),
                        20,
                        Rgb.grey(0.1),
                        Rgb.BLACK))),
            19),
        first.placements().get(1));
    Scene second = file.scenes().get(1);
    assertEquals("leaning-box", second.title());
    assertEquals(400, second.width());
    assertEquals(first.background(), second.background());
    assertEquals(new Perspective(30, true, 0), second.camera().projection());
    assertEquals(Material.WHITE, second.placements().get(1).material());
  }

  @Test
  void thePageNamesEveryKey() {
    Set<String> named = words(DOC);
    for (Section section : Section.values()) {
      for (String key : section.keys()) {
        assertTrue(named.contains(key), key);
      }
    }
  }

  @Test
  void thePageListsWhatIsNotRenderedYet() {
    Set<String> later = new TreeSet<>();
    for (Section section : Section.values()) {
      later.addAll(section.later());
    }
    assertEquals(later, words(between("## Known, but not rendered yet", "\n## ")));
  }

  @Test
  void thePageShowsARealMessage() {
    String text =
        """
        materials: {glass: {color: 1}}
        scenes:
          s:
            camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}
            surfaces:
              - sphere:
                  center: [0, 0, 0]
                  radius: 1
                  material: glas
        """;
    String message = Resources.read(text, "f.yaml").problems().get(0).message();
    assertTrue(DOC.contains("scenes/gallery.yaml:14:19: " + message), message);
  }

  @Test
  void thePageStatesTheLimits() {
    assertEquals(64 << 20, SourceText.MOST_BYTES);
    assertEquals(5_000_000, YamlComposer.MOST_NODES);
    assertEquals(64, YamlComposer.DEEPEST);
    String text = DOC.replaceAll("\\s+", " ");
    assertTrue(text.contains("up to 64 MiB and, its aliases written out, 5 million values"));
    assertTrue(text.contains("nested up to 64 deep"));
  }

  /** Returns the words that stand in back quotes, those inside a longer quote included. */
  private static Set<String> words(String text) {
    Set<String> words = new TreeSet<>();
    Matcher quoted = Pattern.compile("`([^`\n]+)`").matcher(text);
    while (quoted.find()) {
      Matcher word = Pattern.compile("[a-z_0-9]+").matcher(quoted.group(1));
      while (word.find()) {
        words.add(word.group());
      }
    }
    return words;
  }
}

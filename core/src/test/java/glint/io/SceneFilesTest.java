package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What does not depend on what a scene says: names, bytes, numbers of problems. */
class SceneFilesTest {

  private static final String YAML =
      "scenes: {a: {camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}}}\n";
  private static final String CS315 = "Camera 0 0 5 0 1 0 0 0 0 40 1\nOutput 9 9 a.png\n";

  private static List<String> problems(byte[] bytes, String fileName) {
    List<String> lines = new ArrayList<>();
    Resources.read(bytes, fileName).problems().forEach(p -> lines.add(p.toString()));
    return lines;
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.yaml", "a.yml", "x.txt/A.YAML", "a.txt.yml"})
  void yamlByName(String name) {
    assertEquals(1, Resources.read(YAML, name).scenes().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.txt", "x.yaml/A.TXT"})
  void cs315ByName(String name) {
    assertEquals(1, Resources.read(CS315, name).scenes().size());
  }

  @Test
  void otherNamesAreRefused() {
    for (String name : List.of("a.json", "a", "yaml", "a.yaml.bak", "")) {
      assertEquals(
          List.of(
              name
                  + ": unknown kind of file: scene files end in .yaml or .yml, or in .txt if they"
                  + " are in the CS 315 format; models end in .obj"),
          problems(utf8(YAML), name));
    }
  }

  @Test
  void byteOrderMarkAndAllLineEndsAreTaken() {
    for (String end : List.of("\n", "\r\n", "\r")) {
      String text = "\uFEFF" + CS315.replace("\n", end) + "Spere" + end;
      assertEquals(
          List.of("a.txt:3:1: unknown command 'Spere'; did you mean 'Sphere'?"),
          problems(utf8(text), "a.txt"));
      String yaml = "\uFEFF" + YAML.replace("\n", end) + "sceens: 1" + end;
      assertEquals(
          List.of("a.yaml:2:1: unknown key 'sceens' in a scene file; did you mean 'scenes'?"),
          problems(utf8(yaml), "a.yaml"));
    }
  }

  @Test
  void binaryFilesAreRefusedInOneLine() {
    byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13};
    byte[] gzip = {0x1F, (byte) 0x8B, 8, 0};
    byte[] latin = "title: Würfel".getBytes(StandardCharsets.ISO_8859_1);
    byte[] cut = {'a', (byte) 0xE2, (byte) 0x82};
    for (String name : List.of("a.yaml", "a.txt")) {
      String at = name + ":";
      String end = "): not a text file?";
      assertEquals(List.of(at + "1:1: is not UTF-8 text (byte 0x89" + end), problems(png, name));
      assertEquals(
          List.of(at + "1:1: holds a control character (0x1F" + end), problems(gzip, name));
      assertEquals(List.of(at + "1:9: is not UTF-8 text (byte 0xFC" + end), problems(latin, name));
      assertEquals(List.of(at + "1:2: is not UTF-8 text (byte 0xE2" + end), problems(cut, name));
      assertEquals(
          List.of(at + "2:2: holds a control character (0x00" + end),
          problems(utf8("#\n \0"), name));
      assertEquals(
          List.of(at + "1:1: is not UTF-8 text (byte 0xFE" + end),
          problems("a".getBytes(StandardCharsets.UTF_16), name));
    }
  }

  @Test
  void endlessFilesAreRefused() throws IOException {
    InputStream endless =
        new InputStream() {
          @Override
          public int read() {
            return '#';
          }

          @Override
          public int read(byte[] b, int off, int len) {
            java.util.Arrays.fill(b, off, off + len, (byte) '#');
            return len;
          }
        };
    assertEquals(
        "zero.yaml: is too large: scene files hold up to 64 MiB",
        SceneFiles.read(endless, "zero.yaml", Resources.MODELS).problems().get(0).toString());
  }

  @Test
  void aFailingStreamThrows() {
    InputStream failing =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw new IOException("gone");
          }

          @Override
          public int read(byte[] b, int off, int len) throws IOException {
            throw new IOException("gone");
          }
        };
    assertThrows(IOException.class, () -> SceneFiles.read(failing, "a.yaml", Resources.MODELS));
  }

  @Test
  void longLinesOfErrorsAreCut() {
    List<String> problems = problems(utf8(CS315 + "Sphere 0 0 0 x\n".repeat(250) + "\n"), "a.txt");
    assertEquals(101, problems.size());
    assertEquals("a.txt:3:14: expected a number, but found 'x'", problems.get(0));
    assertEquals("a.txt:102:14: expected a number, but found 'x'", problems.get(99));
    assertEquals("a.txt: and 150 more problems, not shown", problems.get(100));
  }

  @Test
  void aFileOfErrorsIsNotReadToItsEnd() {
    byte[] text = utf8(CS315 + "Sphere 0 0 0 x\n".repeat(20_000));
    List<String> problems = problems(text, "a.txt");
    assertEquals(101, problems.size());
    assertEquals(
        "a.txt: and 9900 more problems, not shown; reading ended there", problems.get(100));
    assertEquals(
        "a.yaml: and 9900 more problems, not shown; reading ended there",
        problems(utf8("scenes:\n a:\n  lights:\n" + "   - a\n".repeat(20_000)), "a.yaml").get(100));
  }

  /** Defaults are written once and taken many times, as if by an alias. */
  @Test
  void defaultsAreNoBomb() {
    StringBuilder text = new StringBuilder("defaults:\n  lights:\n");
    for (int i = 0; i < 2500; i++) {
      text.append("    - ambient: {color: 0.001}\n");
    }
    text.append("scenes:\n");
    for (int i = 0; i < 2500; i++) {
      text.append("  s").append(i).append(": {}\n");
    }
    assertEquals(
        List.of("a.yaml:2504:3: too large: so many scenes cannot share so many default lights"),
        problems(utf8(text.toString()), "a.yaml"));
  }

  @Test
  void whatWasWrittenIsShownShortAndInOneLine() {
    String name = "x".repeat(1000);
    String problem = problems(utf8(YAML + name + ": 1"), "a.yaml").get(0);
    assertEquals(
        "a.yaml:2:1: unknown key '"
            + "x".repeat(40)
            + "…' in a scene file; known here: scenes, materials, defaults",
        problem);
    String twoLines = problems(utf8(YAML + "\"a\\nb\": 1"), "a.yaml").get(0);
    assertTrue(twoLines.startsWith("a.yaml:2:1: unknown key 'a b' in"), twoLines);
    String camera = "{camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}}";
    String badName =
        problems(utf8("scenes: {\"a\\nb" + "y".repeat(1000) + "\": " + camera + "}"), "a.yaml")
            .get(0);
    assertTrue(badName.length() < 500 && badName.indexOf('\n') < 0, badName);
  }

  @Test
  void anotherLocaleChangesNothing() {
    Locale before = Locale.getDefault();
    try {
      for (String tag : List.of("de-DE", "tr-TR", "ar-EG", "hi-IN-u-nu-deva")) {
        Locale.setDefault(Locale.forLanguageTag(tag));
        assertEquals(1, Resources.read(YAML, "A.YAML").scenes().size());
        assertEquals(1, Resources.read(CS315, "A.TXT").scenes().size());
        assertEquals(
            List.of(
                "a.yaml:1:1: unknown key 'TITLE' in a scene file;"
                    + " known here: scenes, materials, defaults",
                "a.yaml:1:1: a scene file needs 'scenes'"),
            problems(utf8("TITLE: 1"), "a.yaml"));
        assertEquals(
            List.of("a.yaml:1:1: is not UTF-8 text (byte 0xFF): not a text file?"),
            problems(new byte[] {(byte) 0xFF}, "a.yaml"));
      }
    } finally {
      Locale.setDefault(before);
    }
  }
}

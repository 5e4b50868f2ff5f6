package glint.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.math.Vector3d;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Holds core to its design: data flows one way, and nothing but plain Java is needed. */
class ArchitectureTest {

  /** From the bottom up: a package may import itself and those before it. */
  private static final List<String> LAYERS =
      List.of(
          "math",
          "sampling",
          "color",
          "image",
          "geometry",
          "accel",
          "optics",
          "light",
          "scene",
          "trace",
          "render",
          "io",
          "verify",
          "report");

  private static final Path SOURCES = Path.of("src", "main", "java", "glint");
  private static final Pattern IMPORT = Pattern.compile("(?m)^import (?:static )?([\\w.]+);");
  private static final Pattern QUALIFIED = Pattern.compile("\\bglint\\.([a-z]+)\\.[A-Z]");

  @Test
  void packagesImportOnlyDownward() throws IOException {
    List<String> wrong = new ArrayList<>();
    int files = 0;
    for (Path file : sources()) {
      String own = file.getParent().getFileName().toString();
      assertTrue(LAYERS.contains(own), "package glint." + own + " has no place in the layers");
      Matcher used = QUALIFIED.matcher(Files.readString(file));
      while (used.find()) {
        if (LAYERS.indexOf(used.group(1)) > LAYERS.indexOf(own)) {
          wrong.add(file + " uses " + used.group());
        }
      }
      files++;
    }
    assertTrue(files > 30, "the sources were not found: " + files);
    assertEquals(List.of(), wrong);
  }

  @Test
  void coreImportsNeitherToolkitsNorFiles() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path file : sources()) {
      Matcher imports = IMPORT.matcher(Files.readString(file));
      while (imports.find()) {
        String name = imports.group(1);
        boolean plain = name.startsWith("java.") || name.startsWith("glint.");
        boolean yaml = name.startsWith("org.snakeyaml.") && file.getParent().endsWith("io");
        boolean toolkit = name.startsWith("java.awt") || name.startsWith("java.nio.file");
        if (toolkit || !(plain || yaml)) {
          wrong.add(file + " imports " + name);
        }
      }
    }
    assertEquals(List.of(), wrong);
  }

  @Test
  void kernelsKeepToStrictArithmetic() throws IOException {
    // Functions of Math that may differ between platforms, and fused multiply-add.
    Pattern loose =
        Pattern.compile(
            "\\bMath\\.(sin|cos|tan|asin|acos|atan|atan2|exp|log|log10|pow|cbrt|hypot|sinh|cosh"
                + "|tanh|expm1|log1p|fma|toRadians|toDegrees)\\b");
    List<String> wrong = new ArrayList<>();
    for (Path file : sources()) {
      Matcher used = loose.matcher(Files.readString(file).replace("StrictMath", "S"));
      while (used.find()) {
        wrong.add(file + " uses " + used.group());
      }
    }
    assertEquals(List.of(), wrong);
  }

  @Test
  void coreNeedsTheModuleJavaBaseAlone() throws Exception {
    Path classes =
        Path.of(Vector3d.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    StringWriter out = new StringWriter();
    int exit =
        ToolProvider.findFirst("jdeps")
            .orElseThrow()
            .run(
                new PrintWriter(out),
                new PrintWriter(out),
                "--ignore-missing-deps",
                "--print-module-deps",
                classes.toString());
    assertEquals("java.base", out.toString().trim());
    assertEquals(0, exit);
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> walk = Files.walk(SOURCES)) {
      return walk.filter(p -> p.toString().endsWith(".java")).sorted().toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}

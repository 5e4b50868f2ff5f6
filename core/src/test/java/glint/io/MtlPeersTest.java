package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import glint.color.Rgb;
import glint.optics.Material;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The materials of the test models of tinyobjloader, held against what that reader finds. */
class MtlPeersTest {

  private static final Path FOLDER = Resources.repository().resolveSibling("shared/data/obj");
  private static final Path TABLE = FOLDER.resolve("expected_by_peers.csv");
  private static final Path MODELS = FOLDER.resolve("tinyobjloader/models");

  /** Models whose materials are missing, and where that is told; it is about no other. */
  private static final Map<String, String> MISSING =
      Map.of(
          "issue-161-inconsistent-f", "19:8: material 'cube' is in no library",
          "issue-244-mtl-searchpaths", "2:8: material library 'issue-244.mtl' cannot be read",
          "missing_material_file", "11:8: material 'white' is in no library",
          "mtllib-multiple-files-issue-112", "1:8: material library 'invalid-file-aaa.mtl'",
          "mtl filename with whitespace issue46", "1:8: material library 'invalid-file-without");

  /** What one line of the table says: a model and how many materials its libraries hold. */
  record Expected(String name, int materials) {}

  static List<Expected> models() throws IOException {
    List<Expected> models = new ArrayList<>();
    if (!Files.exists(TABLE)) {
      models.add(new Expected("none", 0));
      return models;
    }
    List<String> lines = Files.readAllLines(TABLE);
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.replaceAll("\"([^\"]|\"\")*\"", "").split(",", -1);
      String name = cells[0].replaceAll(".*/|\\.obj$", "");
      models.add(new Expected(name, Integer.parseInt(cells[8])));
    }
    return models;
  }

  private static ObjModel read(String name) throws IOException {
    try (InputStream in = Files.newInputStream(MODELS.resolve(name + ".obj"))) {
      return ObjReader.read(in, name);
    }
  }

  private static MtlLibrary library(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return MtlReader.read(in, file.getFileName().toString());
    }
  }

  @ParameterizedTest
  @MethodSource("models")
  void hasTheMaterialsThatThePeerFinds(Expected expected) throws IOException {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    ObjModel model = read(expected.name());
    if (model.mesh() == null) {
      return; // ObjPeersTest tells of it
    }
    Set<Path> opened = new TreeSet<>();
    SceneFolder beside =
        path -> {
          InputStream in = Files.newInputStream(MODELS.resolve(path));
          opened.add(MODELS.resolve(path));
          return in;
        };
    ModelMaterials materials =
        new ModelMaterials(model, expected.name(), beside, new Images(beside));
    assertEquals(List.of(), materials.problems());
    assertEquals(model.mesh().parts(), materials.parts().size());
    int count = 0;
    for (Path file : opened) {
      count += library(file).materials().size();
    }
    boolean needed = model.materials().stream().anyMatch(name -> name.line() > 0);
    assertEquals(needed ? expected.materials() : 0, count);
    List<String> missing =
        materials.notes().stream()
            .map(Problem::toString)
            .filter(note -> note.contains("librar"))
            .collect(Collectors.toList());
    String told = MISSING.get(expected.name());
    assertEquals(told != null, !missing.isEmpty(), missing.toString());
    assertTrue(told == null || missing.get(0).startsWith(expected.name() + ":" + told));
  }

  @Test
  void everyLibraryIsSound() throws IOException {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    try (var files = Files.list(MODELS)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".mtl")).sorted().toList()) {
        MtlLibrary library = library(file);
        assertEquals(List.of(), library.problems());
        long statements =
            Files.readAllLines(file).stream().filter(l -> l.trim().startsWith("newmtl")).count();
        assertEquals(statements, library.materials().size(), file.toString());
      }
    }
  }

  private static MtlMaterial material(String file, String name) throws IOException {
    return library(MODELS.resolve(file)).materials().get(name);
  }

  @Test
  void valuesAreWhatTheFilesSay() throws IOException {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    Material light = material("cornell_box.mtl", "light").material();
    assertEquals(Rgb.grey(20), light.ambient());
    assertEquals(Rgb.WHITE, light.diffuse());
    Material test1 = material("issue-138.mtl", "test1").material();
    assertEquals(new Rgb(0.5, 0.2, 0.2), test1.diffuse());
    assertEquals(10, test1.shininess());
    assertEquals(Rgb.BLACK, test1.transparency(), "Tf of a model without glass");
    for (String name : List.of("Material.001", "Material.002")) {
      Material m = material("tr-and-d-issue-43.mtl", name).material();
      assertEquals(Rgb.grey(0.25), m.transparency(), "d before Tr");
    }
    assertEquals(
        Rgb.WHITE, material("issue-356-leading-spaces-newmtl.mtl", "aaa").material().ambient());
    assertEquals(Rgb.grey(0.1), material("pbr-mat-ext.mtl", "pbr").material().emission());
    assertEquals("texture 01.png", file("texture-filename-with-whitespace.mtl", "white"));
    assertEquals("diffuse.jpg", file("texture-options-issue-85.mtl", "bm2"));
    assertEquals("diffuse.jpg", file("colorspace-issue-184.mtl", "default"));
    assertEquals("input.jpg", file("issue-248-texres-texopt.mtl", "white"));
    MtlMap map = material("texture-options-issue-85.mtl", "default").map().orElseThrow();
    assertEquals(0.1, map.layout().offsetU());
  }

  private static String file(String library, String name) throws IOException {
    return material(library, name).map().orElseThrow().file();
  }
}

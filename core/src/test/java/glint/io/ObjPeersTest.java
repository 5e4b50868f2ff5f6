package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import glint.geometry.MeshFacts;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The test models of tinyobjloader, held against what two well-known readers make of them. */
class ObjPeersTest {

  /** The models are not ours to pass on; they lie beside the repository. */
  private static final Path FOLDER = Resources.repository().resolveSibling("shared/data/obj");

  private static final Path TABLE = FOLDER.resolve("expected_by_peers.csv");

  /** What makes a file wrong, by line and column. */
  private static final Map<String, List<String>> WRONG =
      Map.of(
          // Nothing stands before the face that counts back, or but one texture point
          "invalid-relative-vertex-index", List.of("1:3"),
          "invalid-relative-texture-index", List.of("2:13"),
          // Indices 0, of points and of normals; trimesh takes them for the last one
          "issue-140-zero-face-idx", List.of("16:3", "17:3"),
          // v nan -nan nan, v inf -inf inf, v 1.#IND -1.#IND 1.#IND, v 1.#INF -1.#INF 1.#INF
          "test-nan", List.of("12:3", "13:3", "14:3", "15:3"));

  /**
   * Triangles and area where the peers differ, and how far the area may be off.
   *
   * <p>The areas are those of the mean planes, computed apart from this reader; the corners lie off
   * them by up to a thousandth, so that areas of triangles may be larger by such a share.
   */
  private static final Map<String, double[]> DECIDED = new HashMap<>();

  static {
    // Two concave faces of 7 and 8 corners and one of 5 make 5 + 6 + 3 triangles: tinyobjloader
    // drops some, trimesh fans them so that they overlap.
    DECIDED.put("issue-319-002", new double[] {14, 19.5837014, 1e-4});
    // A wall with corners on its straight edges; both peers are near.
    DECIDED.put("issue-319-003", new double[] {8, 616.908982, 1e-5});
    // A quad that is not flat, whose area depends on the diagonal; a fan's is trimesh's.
    DECIDED.put("issue-330", new double[] {3, 0.0450238661, 1e-8});
    // Negative indices between the points, which trimesh counts from the file's end.
    for (String box :
        List.of(
            "cornell_box", "cornell_box_multimaterial", "missing_material_file", "no_material")) {
      DECIDED.put(box, new double[] {36, 1989605.21, 1e-8});
    }
  }

  /** What one peer makes of a model. */
  private record Expected(String name, int triangles, double area) {}

  static List<String> models() throws IOException {
    return Files.exists(TABLE)
        ? rows(6, 7).stream().map(Expected::name).collect(Collectors.toList())
        : List.of("none");
  }

  private static List<Expected> rows(int countColumn, int areaColumn) throws IOException {
    List<Expected> rows = new ArrayList<>();
    List<String> lines = Files.readAllLines(TABLE);
    for (String line : lines.subList(1, lines.size())) {
      // Messages in quotes hold commas and doubled quotes
      String[] cells = line.replaceAll("\"([^\"]|\"\")*\"", "").split(",", -1);
      boolean read = !cells[countColumn].isEmpty();
      String name = cells[0].replaceAll(".*/|\\.obj$", "");
      int count = read ? Integer.parseInt(cells[countColumn]) : -1;
      rows.add(new Expected(name, count, read ? Double.parseDouble(cells[areaColumn]) : 0));
    }
    return rows;
  }

  private static ObjModel read(String name) {
    Path file = FOLDER.resolve("tinyobjloader/models").resolve(name + ".obj");
    try (InputStream in = Files.newInputStream(file)) {
      return ObjReader.read(in, name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @ParameterizedTest
  @MethodSource("models")
  void isReadAsThePeersDo(String name) throws IOException {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    ObjModel model = read(name);
    if (WRONG.containsKey(name)) {
      List<String> places = new ArrayList<>();
      model.problems().forEach(p -> places.add(p.line() + ":" + p.column()));
      assertEquals(WRONG.get(name), places);
      return;
    }
    assertEquals(List.of(), model.problems());
    double area = MeshFacts.area(model.mesh());
    double[] decided = DECIDED.get(name);
    if (decided != null) {
      assertEquals(decided[0], model.mesh().triangles());
      assertEquals(decided[1], area, decided[1] * decided[2]);
      return;
    }
    for (List<Expected> peer : List.of(rows(6, 7), rows(11, 12))) {
      Expected expected = peer.stream().filter(e -> e.name().equals(name)).findFirst().get();
      assertEquals(expected.triangles(), model.mesh().triangles());
      // The table has six digits, and tinyobjloader computes in floats
      double six = expected.area() == 0 ? 0 : Math.pow(10, Math.floor(Math.log10(expected.area())));
      assertEquals(expected.area(), area, 0.5e-5 * six + 1e-6 * expected.area());
    }
  }

  @Test
  void notesTellWhatIsLeftOut() {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    assertEquals(
        List.of(
            "invalid-face-definition:15:1: a face needs three different corners: this one is left"
                + " out (2 times in this file)",
            "invalid-face-definition: holds no faces"),
        read("invalid-face-definition").notes().stream()
            .map(Problem::toString)
            .collect(Collectors.toList()));
    assertEquals(List.of(), read("cube-vertexcol").notes());
  }

  /** So that no model of the folder is without an expectation. */
  @Test
  void everyModelIsInTheTable() throws IOException {
    assumeTrue(Files.exists(TABLE), () -> "skipped: the models are not there: " + TABLE);
    List<String> names = models();
    JsonNode features = new ObjectMapper().readTree(FOLDER.resolve("feature_index.json").toFile());
    for (JsonNode files : features) {
      for (JsonNode file : files) {
        String name = file.asText().replaceAll(".*/", "");
        boolean known = names.contains(name.replaceAll("\\.obj$", ""));
        assertTrue(known || name.endsWith(".mtl"), name);
      }
    }
  }
}

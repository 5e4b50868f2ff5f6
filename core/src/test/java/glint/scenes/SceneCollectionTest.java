package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import glint.io.SceneFile;
import glint.math.Vector3d;
import glint.render.RenderResult;
import glint.scene.Camera;
import glint.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.CoreSchema;

/** The scenes that Glint brings along. */
class SceneCollectionTest {

  /** The commands of the CS 315 format. */
  private static final Set<String> COMMANDS =
      Set.of(
          "Camera",
          "Output",
          "BounceDepth",
          "ShadowBias",
          "PushMatrix",
          "PopMatrix",
          "Translate",
          "Scale",
          "Rotate",
          "Sphere",
          "Triangle",
          "AmbientLight",
          "PointLight",
          "DirectionalLight",
          "Material");

  static Stream<Path> files() {
    return Repository.sceneFiles().stream();
  }

  static Stream<Arguments> scenes() {
    return files()
        .flatMap(file -> Repository.read(file).scenes().stream())
        .map(scene -> Arguments.of(scene.name(), scene));
  }

  @ParameterizedTest
  @MethodSource("files")
  void readsWithoutProblem(Path path) {
    SceneFile file = Repository.read(path);
    assertEquals(0, file.problems().size(), () -> file.problems().toString());
    assertFalse(file.scenes().isEmpty());
  }

  @ParameterizedTest
  @ValueSource(strings = {"gallery.yaml", "stories.yaml"})
  void fileIsValidByItsSchema(String name) throws IOException {
    Path folder = Repository.root().resolve("scenes");
    String text = Files.readString(folder.resolve(name));
    String named = text.substring(text.indexOf("$schema=") + 8, text.indexOf('\n'));
    String schema = Files.readString(folder.resolve(named));
    LoadSettings core = LoadSettings.builder().setSchema(new CoreSchema()).build();
    JsonNode tree = new ObjectMapper().valueToTree(new Load(core).loadFromString(text));
    JsonSchemaFactory factory = JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V7);
    assertEquals(Set.of(), factory.getSchema(schema).validate(tree));
  }

  @Test
  void namesAreUnique() {
    Set<String> names = new TreeSet<>();
    scenes().forEach(scene -> assertTrue(names.add((String) scene.get()[0]), names::toString));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("scenes")
  void rendersToAPicture(String name, Scene scene) {
    RenderResult result = Repository.render(scene, 64, 48);
    assertEquals(0, result.statistics().invalid());
    assertFalse(Repository.isFlat(result.image()));
    // Highlights may be whiter than the display, and nothing else.
    assertTrue(result.statistics().clipped() < 64 * 48 / 100, () -> result.statistics().toString());
  }

  @Test
  void everyCommandOfTheCourseIsUsed() throws IOException {
    Set<String> used = new TreeSet<>();
    for (Path file : Repository.sceneFiles()) {
      if (file.toString().endsWith(".txt")) {
        Files.readAllLines(file).forEach(line -> used.add(line.trim().split("\\s", 2)[0]));
      }
    }
    used.removeIf(word -> word.isEmpty() || word.startsWith("#"));
    assertEquals(new TreeSet<>(COMMANDS), used);
  }

  /** The lab's camera looks along the inverse of its back vector; z is up. */
  @ParameterizedTest
  @CsvSource({"pyramid-reflection, 12, 80", "sphere-on-the-table, 26, 75", "transparency, 0, 77"})
  void studyScenesLookAsTheLabSays(String name, double a, double b) {
    Scene scene = (Scene) scenes().filter(s -> s.get()[0].equals(name)).findFirst().get().get()[1];
    Camera camera = scene.camera();
    double sinA = Math.sin(Math.toRadians(a));
    double cosA = Math.cos(Math.toRadians(a));
    double sinB = Math.sin(Math.toRadians(b));
    Vector3d back = new Vector3d(sinA * sinB, cosA * sinB, Math.cos(Math.toRadians(b)));
    Vector3d view = camera.lookAt().minus(camera.position()).normalized();
    assertTrue(view.plus(back).maxAbs() < 1e-5, () -> view + " is not the inverse of " + back);
    assertEquals(new Vector3d(0, 0, 1), camera.up());
  }
}

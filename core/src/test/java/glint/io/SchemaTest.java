package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SchemaId;
import com.networknt.schema.SchemaLocation;
import com.networknt.schema.SpecVersion;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.schema.CoreSchema;

/** The schema that editors use and the reader agree on what a scene file is. */
class SchemaTest {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final JsonNode TREE = tree();
  private static final JsonSchemaFactory FACTORY =
      JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V7);
  private static final JsonSchema SCHEMA = FACTORY.getSchema(TREE);

  private static JsonNode tree() {
    try {
      return JSON.readTree(Resources.repositoryText("scenes/schema/glint-scene.schema.json"));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static Set<ValidationMessage> validate(String yaml) {
    return SCHEMA.validate(load(yaml));
  }

  /** Loads YAML by the engine's own loader, which knows nothing of our reader. */
  private static JsonNode load(String yaml) {
    LoadSettings core = LoadSettings.builder().setSchema(new CoreSchema()).build();
    return JSON.valueToTree(new Load(core).loadFromString(yaml));
  }

  static List<Resources.Bad> structure() {
    return ofKind("structure");
  }

  static List<Resources.Bad> meaning() {
    return ofKind("meaning");
  }

  private static List<Resources.Bad> ofKind(String kind) {
    return Resources.bad("bad-yaml.txt").stream()
        .filter(bad -> bad.kind().equals(kind))
        .collect(Collectors.toList());
  }

  @Test
  void theSchemaIsOne() {
    JsonSchema draft = FACTORY.getSchema(SchemaLocation.of(SchemaId.V7));
    assertEquals(Set.of(), draft.validate(TREE));
    assertEquals(SchemaId.V7, TREE.get("$schema").asText());
  }

  @Test
  void goodScenesValidate() {
    assertEquals(Set.of(), validate(Resources.text("everything.yaml")));
    assertEquals(Set.of(), validate(SceneFormatDocTest.example()));
  }

  @Test
  void theScenesOfTheRepositoryAreGood() throws IOException {
    for (Path file : Resources.scenes(".yaml")) {
      String text = Files.readString(file);
      assertEquals(Set.of(), validate(text), file.toString());
      assertEquals(List.of(), Resources.read(file).problems());
    }
  }

  @ParameterizedTest
  @MethodSource("structure")
  void bothRejectABadStructure(Resources.Bad bad) {
    assertTrue(!validate(bad.text()).isEmpty(), bad.text());
    assertTrue(!Resources.read(bad.text(), "f.yaml").problems().isEmpty());
  }

  /** What only the reader can know: a name that is not defined, two values that do not fit. */
  @ParameterizedTest
  @MethodSource("meaning")
  void theSchemaLeavesMeaningToTheReader(Resources.Bad bad) {
    assertEquals(Set.of(), validate(bad.text()));
    assertTrue(!Resources.read(bad.text(), "f.yaml").problems().isEmpty());
  }

  @ParameterizedTest
  @EnumSource
  void bothKnowTheSameKeys(Section section) {
    String name = section.name().toLowerCase(Locale.ROOT);
    JsonNode definition = section == Section.FILE ? TREE : TREE.get("definitions").get(name);
    assertEquals(new TreeSet<>(section.keys()), keys(definition.get("properties")));
    assertEquals(false, definition.get("additionalProperties").asBoolean(true));
  }

  @Test
  void theSchemaHasNoMapThatTheReaderLacks() {
    List<String> maps = new ArrayList<>();
    TREE.get("definitions")
        .fields()
        .forEachRemaining(
            each -> {
              if (each.getValue().has("properties")) {
                maps.add(each.getKey().toUpperCase(Locale.ROOT));
              }
            });
    for (Section section : Section.values()) {
      maps.remove(section.name());
    }
    assertEquals(List.of(), maps);
  }

  /** So that no key is without a test of its value, in YamlScenesTest. */
  @Test
  void theGoodFileUsesEveryKey() {
    Set<String> used = new TreeSet<>();
    collect(load(Resources.text("everything.yaml")), used);
    for (Section section : Section.values()) {
      for (String key : section.keys()) {
        assertTrue(used.contains(key), key);
      }
    }
  }

  private static void collect(JsonNode node, Set<String> names) {
    names.addAll(keys(node));
    node.forEach(child -> collect(child, names));
  }

  private static Set<String> keys(JsonNode node) {
    Set<String> keys = new TreeSet<>();
    for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
      keys.add(names.next());
    }
    return keys;
  }
}

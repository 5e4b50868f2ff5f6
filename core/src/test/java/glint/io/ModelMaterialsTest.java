package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.geometry.Mesh;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the parts of a model are made of. */
class ModelMaterialsTest {

  private static final String FOUR = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

  private final Map<String, String> files = new HashMap<>();
  private final List<String> asked = new ArrayList<>();

  private final SceneFolder folder =
      new SceneFolder() {
        @Override
        public InputStream open(String path) throws IOException {
          asked.add(path);
          if (!files.containsKey(path)) {
            throw new IOException("no such file");
          }
          return new ByteArrayInputStream(files.get(path).getBytes(StandardCharsets.UTF_8));
        }
      };

  private ModelMaterials materials(String text) {
    return new ModelMaterials(ObjText.read(text), "m.obj", folder, new Images(folder));
  }

  private static List<String> names(Mesh mesh, ObjModel model) {
    List<String> names = new ArrayList<>();
    for (int i = 0; i < mesh.triangles(); i++) {
      names.add(model.materials().get(mesh.part(i)).text());
    }
    return names;
  }

  private static List<String> ofTriangles(String text) {
    ObjModel model = ObjText.read(text);
    assertEquals(List.of(), model.problems());
    return names(model.mesh(), model);
  }

  private static List<String> lines(List<Problem> problems) {
    return problems.stream().map(Problem::toString).collect(Collectors.toList());
  }

  @Test
  void facesAreOfTheMaterialNamedLast() {
    assertEquals(List.of("", ""), ofTriangles(FOUR + "f 1 2 3\nf 1 3 4\n"));
    assertEquals(
        List.of("", "a", "a", "b", "a", "a"),
        ofTriangles(
            FOUR
                + "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl none\no x\ng y\ns 1\nusemtl a\nf 1 3 4\n"
                + "usemtl b\nf 1 2 3\nusemtl a\nf 1 2 3 4\n"));
    assertEquals(List.of("a"), ofTriangles("usemtl a\n" + FOUR + "usemtl b\nusemtl a\nf 1 2 3\n"));
  }

  @Test
  void facesBeforeTheirPointsKeepTheirMaterial() {
    assertEquals(
        List.of("b", "a", "c", "c", ""),
        ofTriangles(
            "usemtl a\nf 1 2 3\nusemtl c\nf 1 2 3 4\nusemtl b\n"
                + FOUR
                + "f 1 2 3\n"
                + "usemtl\nf 1 2 9\n"
                + FOUR
                + FOUR));
  }

  @Test
  void whatIsLeftOutLeavesNoPart() {
    String text = FOUR + "usemtl a\nf 1 2\nusemtl b\nf 1 2 3\nusemtl c\nf 1 1 1\n";
    ObjModel model = ObjText.read(text);
    assertEquals(1, model.mesh().parts());
    assertEquals(List.of("b"), names(model.mesh(), model));
    assertEquals(1, model.materials().size());
  }

  @Test
  void librariesMayComeAfterTheirUse() {
    files.put("a.mtl", "newmtl red\nKd 1 0 0\n");
    files.put("b.mtl", "newmtl red\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n");
    ModelMaterials found =
        materials(
            "usemtl red\n" + FOUR + "f 1 2 3\nusemtl blue\nf 1 2 3\nmtllib a.mtl\nmtllib b.mtl");
    assertEquals(List.of(), found.notes());
    assertEquals(2, found.parts().size());
    assertEquals("red", found.parts().get(0).name());
    Rgb red = found.parts().get(0).material().orElseThrow().diffuse();
    assertEquals(new Rgb(1, 0, 0), red, "the first library counts");
    assertEquals("blue", found.parts().get(1).name());
  }

  @ParameterizedTest
  @CsvSource({
    "a.mtl,                  a.mtl",
    "'a.mtl b.mtl',          a.mtl b.mtl;a.mtl;b.mtl",
    "'my a.mtl your b.mtl',  my a.mtl your b.mtl;my a.mtl;your b.mtl",
    "'one file.mtl',         one file.mtl",
    "'one two',              one two",
    "'a.mtl \t last',        a.mtl   last;a.mtl;last",
    "x\\y\\a.mtl,            x/y/a.mtl",
    "'my\\ a.mtl',           my a.mtl",
    "'A.MTL b.mtl',          A.MTL b.mtl;A.MTL;b.mtl",
  })
  void namesOfLibraries(String written, String expected) {
    for (String name : expected.split(";")) {
      files.put(name, "newmtl x\n");
    }
    String text = "mtllib " + written + "\n" + FOUR + "usemtl x\nf 1 2 3\n";
    assertEquals(List.of(), materials(text).notes());
    // All of the line may be one name.
    assertEquals(List.of(expected.split(";")[0]), asked);
    asked.clear();
    if (expected.contains(";")) {
      files.remove(expected.split(";")[0]);
      assertEquals(List.of(), materials(text).notes());
      assertEquals(List.of(expected.split(";")), asked);
    }
  }

  /** O11. */
  @Test
  void whatIsMissingIsOneNoteAndNoMaterial() {
    files.put("a.mtl", "newmtl red\nKd 1 0 0\n");
    String faces = FOUR + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl green\nf 1 2 3\n";
    ModelMaterials found = materials("mtllib none.mtl\n" + faces);
    assertEquals(
        List.of("m.obj:1:8: material library 'none.mtl' cannot be read: no such file"),
        lines(found.notes()));
    assertTrue(found.parts().stream().noneMatch(part -> part.material().isPresent()));
    assertEquals(
        List.of(
            "m.obj:8:8: material 'blue' is in no library of this model, nor are 1 others:"
                + " the default material is taken"),
        lines(materials("mtllib a.mtl\n" + faces).notes()));
    assertEquals(
        List.of(
            "m.obj:5:8: material 'red' is in no library of this model, nor are 2 others:"
                + " the default material is taken"),
        lines(materials(faces).notes()));
  }

  @Test
  void aLibraryOfAnotherComputerIsLookedForBesideTheModel() {
    files.put("a.mtl", "newmtl red\nKd 1 0 0\n");
    String text = "mtllib C:\\me\\a.mtl\n" + FOUR + "usemtl red\nf 1 2 3\n";
    ModelMaterials found = materials(text);
    assertTrue(found.parts().get(0).material().isPresent());
    assertEquals(
        List.of(
            "m.obj:1:8: material library 'C:/me/a.mtl' cannot be read: no such file;"
                + " 'a.mtl' is taken instead"),
        lines(found.notes()));
    assertEquals(List.of("C:/me/a.mtl", "a.mtl"), asked);
  }

  @Test
  void librariesAreReadOnceAndOnlyIfFacesNeedThem() {
    files.put("a.mtl", "newmtl red\nKd 1 0 0\nfoo\n");
    String many = "mtllib a.mtl\n".repeat(99) + "mtllib  a.mtl # again\nmtllib b.mtl a.mtl\n";
    assertTrue(materials(many + FOUR + "f 1 2 3\n").notes().isEmpty());
    assertEquals(List.of(), asked);
    ModelMaterials found = materials(many + FOUR + "usemtl red\nf 1 2 3\n");
    assertEquals(1, asked.stream().filter("a.mtl"::equals).count());
    assertTrue(lines(found.notes()).contains("a.mtl:3:1: 'foo' is not read: the line is left out"));
  }

  @Test
  void aCommentMayFollowAName() {
    files.put("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl Material #2\n");
    ModelMaterials found =
        materials(
            "mtllib a.mtl\n"
                + FOUR
                + "usemtl red # as blood\nf 1 2 3\nusemtl Material #2\nf 1 2 3\n"
                + "usemtl Material #2 #once #twice\nf 1 2 3\n");
    assertEquals(List.of(), found.notes());
    assertTrue(found.parts().stream().allMatch(part -> part.material().isPresent()));
  }

  @Test
  void problemsOfALibraryAreToldWithItsName() {
    files.put("a.mtl", "newmtl red\nKd 1 0 x\n");
    ModelMaterials found = materials("mtllib a.mtl\n" + FOUR + "usemtl red\nf 1 2 3\n");
    assertEquals(List.of("a.mtl:2:8: expected a number, but found 'x'"), lines(found.problems()));
    assertEquals(List.of(), found.notes());
  }

  @Test
  void anEmptyModelHasOnePart() {
    ObjModel model = ObjText.read("usemtl a\nmtllib a.mtl\n");
    assertEquals(1, model.materials().size());
    assertEquals(1, model.mesh().parts());
    assertEquals(1, materials("usemtl a\n").parts().size());
    assertNull(ObjText.read("v x\n").mesh());
  }
}

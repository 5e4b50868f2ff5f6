package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.image.ByteImage;
import glint.image.Noise;
import glint.optics.ImageTexture;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Texel;
import glint.optics.Wrap;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Images are found, decoded once, and told of where they are missing. */
class ImagesTest {

  private static final String SCENE =
      "scenes:\n  s:\n    camera: {position: [0, 0, 5], look_at: [0, 0, 0], fov: 40}\n"
          + "    surfaces:\n";
  private static final String BALL = "      - sphere: {center: [0, 0, 0], radius: 1, material: ";
  private static final String PAIRED =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl a\nf 1/1 2/2 3/3\n";

  private final Map<String, String> files = new HashMap<>();
  private final List<String> asked = new ArrayList<>();

  /** Files by their paths; an image is broken, a little damaged, or noise. */
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

        @Override
        public String name(String path) {
          return "here/" + path;
        }

        @Override
        public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
          String content = new String(in.readAllBytes(), StandardCharsets.UTF_8);
          if (content.equals("broken")) {
            throw new IOException("ends too early");
          }
          if (content.equals("damaged")) {
            remarks.accept("is damaged");
          }
          return Noise.of(4, 4);
        }
      };

  private SceneFile read(String text) {
    return Resources.read(text.getBytes(StandardCharsets.UTF_8), "f.yaml", folder);
  }

  private static List<String> notes(SceneFile file) {
    assertEquals(List.of(), file.problems());
    return file.notes().stream().map(Problem::toString).collect(Collectors.toList());
  }

  private static ImageTexture image(Material material) {
    return (ImageTexture) material.texture().orElseThrow();
  }

  private static List<ByteImage> images(SceneFile file) {
    List<ByteImage> images = new ArrayList<>();
    for (Placement placement : file.scenes().get(0).placements()) {
      for (NamedMaterial each : placement.materials()) {
        images.add(image(each.material()).image());
      }
    }
    return images;
  }

  @Test
  void anImageIsDecodedOnceWhoeverNamesIt() {
    files.put("p/a.png", "damaged");
    files.put("m/a.obj", "mtllib a.mtl\n" + PAIRED);
    files.put("m/a.mtl", "newmtl a\nmap_Kd ../p/a.png\n");
    files.put("m/../p/a.png", "sound"); // paths are compared as they are written
    String text =
        "materials: {a: {texture: {image: p/a.png}}, b: {texture: {image: p/a.png, scale: 2}}}\n"
            + SCENE
            + (BALL + "a}\n")
            + (BALL + "b}\n")
            + (BALL + "{texture: {image: p/a.png}}}\n")
            + "      - mesh: {file: m/a.obj}\n      - mesh: {file: m/a.obj, translate: [1, 0, 0]}\n";
    SceneFile file = read(text);
    assertEquals(List.of("f.yaml:1:34: image 'p/a.png' is damaged"), notes(file));
    assertEquals(List.of("p/a.png", "m/a.obj", "m/a.mtl", "m/../p/a.png"), asked);
    List<ByteImage> images = images(file);
    assertSame(images.get(0), images.get(1));
    assertSame(images.get(0), images.get(2));
    assertSame(images.get(3), images.get(4));
  }

  @Test
  void whatIsMissingOrBrokenIsMagentaAndToldOnce() {
    files.put("b.png", "broken");
    SceneFile file =
        read(
            SCENE
                + (BALL + "{texture: {image: a.png}}}\n")
                + (BALL + "{texture: {image: a.png}}}\n")
                + (BALL + "{texture: {image: b.png}}}\n"));
    assertEquals(
        List.of(
            "f.yaml:5:76: image 'a.png' cannot be read: no such file; magenta stands in for it",
            "f.yaml:7:76: image 'b.png' cannot be read: ends too early; magenta stands in for it"),
        notes(file));
    Texel texel = new Texel();
    image(file.scenes().get(0).placements().get(0).material()).at(texel);
    assertEquals(new Rgb(1, 0, 1), texel.color());
    assertSame(images(file).get(0), images(file).get(2));
  }

  @Test
  void aLibrariesImagesLieBesideIt() {
    files.put("m/a.obj", "mtllib l/a.mtl\n" + PAIRED);
    files.put(
        "m/l/a.mtl",
        "newmtl a\nmap_Kd -s 2 3 -clamp on -mm 0.25 0.5 i/my a.png\nnewmtl b\nmap_Kd no.png");
    files.put("m/l/i/my a.png", "sound");
    SceneFile file = read(SCENE + "      - mesh: {file: m/a.obj}\n");
    assertEquals(List.of(), notes(file));
    assertEquals(List.of("m/a.obj", "m/l/a.mtl", "m/l/i/my a.png"), asked);
    ImageTexture image = image(file.scenes().get(0).placements().get(0).material());
    assertEquals(new Layout(2, 3, 0, 0, Wrap.CLAMP), image.layout());
    ByteImage noise = Noise.of(4, 4);
    double most = new ImageTexture(noise, Layout.ONCE, image.mapping()).most().r();
    assertEquals(0.25 + 0.5 * most, image.most().r());
  }

  @Test
  void anImageOfAnotherComputerIsLookedForBesideTheLibrary() {
    files.put("m/a.obj", "mtllib a.mtl\n" + PAIRED);
    files.put("m/a.mtl", "newmtl a\nKd 1 1 1\n  map_Kd C:\\me\\a.png\n");
    files.put("m/a.png", "sound");
    String scene = SCENE + "      - mesh: {file: m/a.obj}\n";
    assertEquals(
        List.of(
            "here/m/a.mtl:3:3: image 'C:/me/a.png' cannot be read: no such file;"
                + " 'm/a.png' is taken instead"),
        notes(read(scene)));
    files.remove("m/a.png");
    assertEquals(
        List.of(
            "here/m/a.mtl:3:3: image 'C:/me/a.png' cannot be read: no such file;"
                + " magenta stands in for it"),
        notes(read(scene)));
  }

  @Test
  void aModelWithoutTexturePointsIsTold() {
    files.put("a.png", "sound");
    files.put("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3\n");
    files.put("a.mtl", "newmtl a\nmap_Kd a.png\n");
    String mesh = SCENE + "      - mesh: {file: a.obj";
    String told =
        "f.yaml:5:22: the model has no texture points, so that its image shows one colour;"
            + " a texture may have a 'mapping'";
    assertEquals(List.of(told), notes(read(mesh + "}\n")));
    assertEquals(List.of(told), notes(read(mesh + ", material: {texture: {image: a.png}}}\n")));
    String mapped = "{image: a.png, mapping: {spherical: {center: [0, 0, 0]}}}";
    assertEquals(List.of(), notes(read(mesh + ", material: {texture: " + mapped + "}}\n")));
    files.put("a.obj", "mtllib a.mtl\n" + PAIRED);
    assertEquals(List.of(), notes(read(mesh + "}\n")));
  }

  @Test
  void manyMissingImagesAreCounted() {
    StringBuilder library = new StringBuilder();
    StringBuilder model = new StringBuilder("mtllib a.mtl\n" + PAIRED);
    for (int i = 0; i < 2000; i++) {
      library.append("newmtl m").append(i).append("\nmap_Kd ").append(i).append(".png\n");
      model.append("usemtl m").append(i).append("\nf 1/1 2/2 3/3\n");
    }
    files.put("a.mtl", library + "newmtl a\n");
    files.put("a.obj", model.toString());
    List<String> notes = notes(read(SCENE + "      - mesh: {file: a.obj}\n"));
    assertEquals(11, notes.size());
    assertTrue(notes.get(10).startsWith("here/a.mtl: and "), notes.get(10));
  }
}

package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.color.Rgb;
import glint.optics.Layout;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Wrap;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each statement and quirk of MTL files, in a small file of its own. */
class MtlReaderTest {

  private static final Rgb RED = new Rgb(0.8, 0.2, 0.1);
  private static final Rgb GREY = Rgb.grey(0.25);

  static MtlLibrary read(String text, Charset charset) {
    try {
      return MtlReader.read(new ByteArrayInputStream(text.getBytes(charset)), "m.mtl");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static MtlLibrary read(String text) {
    return read(text, StandardCharsets.UTF_8);
  }

  private static MtlMaterial only(String statements) {
    MtlLibrary library = read("newmtl a\n" + statements);
    assertEquals(List.of(), library.problems());
    assertEquals(Set.of("a"), library.materials().keySet());
    return library.materials().get("a");
  }

  private static Material material(String statements) {
    return only(statements).material();
  }

  private static List<String> lines(List<Problem> problems) {
    return problems.stream()
        .map(p -> p.toString().substring("m.mtl:".length()))
        .collect(Collectors.toList());
  }

  private static List<String> notes(String text) {
    MtlLibrary library = read(text);
    assertEquals(List.of(), library.problems());
    return lines(library.notes());
  }

  @Test
  void statementsBecomeThePartsOfAMaterial() {
    Material m =
        material(
            "Ka .1 .2 .3\nKd 0.8 0.2 0.1\nKs 0.25\nNs 96.5\nKe 0 0 2e-1\nillum 2\nNi 1.5\nd 1");
    Rgb ambient = new Rgb(0.1, 0.2, 0.3);
    assertEquals(new Material(ambient, RED, GREY, 96.5, Rgb.BLACK, new Rgb(0, 0, 0.2)), m);
  }

  @Test
  void whatIsNotWrittenIsAsInASceneFile() {
    assertEquals(Material.WHITE, material(""));
    Material red = new Material(RED, RED, Rgb.BLACK, 32, Rgb.BLACK, Rgb.BLACK);
    assertEquals(red, material("Kd .8 .2 .1"));
    assertEquals(Rgb.BLACK, material("Ke 5").diffuse());
    assertEquals(Rgb.BLACK, material("Ks .5\nillum 3").diffuse());
    assertEquals(Rgb.BLACK, material("d .5").diffuse());
    assertEquals(Rgb.WHITE, material("Ke 5\nmap_Kd a.png").diffuse(), "an image lies on white");
    assertEquals(GREY, material("Ks .25").specular(), "a highlight needs no model");
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0,    0, 0,    false",
    "1, 0,    0, 0,    false",
    "2, 0.25, 0, 0,    false",
    "3, 0.25, 0.25, 0, false",
    "4, 0.25, 0.25, 0, false",
    "5, 0.25, 0.25, 0, false",
    "6, 0.25, 0.25, 0.6, true",
    "7, 0.25, 0, 0.8, true",
    "8, 0.25, 0.25, 0, false",
    "9, 0.25, 0.25, 0, false",
    "10, 0.25, 0, 0,   false",
  })
  void modelsOfIllumination(
      int model, double specular, double reflection, double through, boolean bends) {
    Material m = material("Kd .8 .2 .1\nKs .25\nTf .8\nNi 1.5\nillum " + model);
    assertEquals(Rgb.grey(specular), m.specular());
    assertEquals(Rgb.grey(reflection), m.reflection());
    assertEquals(through, m.transparency().r(), 1e-15);
    assertEquals(bends ? new Medium(1.5, Rgb.BLACK, 0) : Medium.VACUUM, m.interior());
    assertEquals(model == 0 ? RED : Rgb.BLACK, m.emission());
    assertEquals(model == 0 ? Rgb.BLACK : RED, m.diffuse());
    assertEquals(model == 0 ? Rgb.BLACK : RED, m.ambient());
  }

  @ParameterizedTest
  @CsvSource({
    "d .75, 0.75",
    "Tr .25, 0.75",
    "d -halo .75, 0.75",
    "'d .75\nTr .25', 0.75",
    "'d .75\nTr .5', 0.75",
    "'Tr .5\nd .75', 0.75",
  })
  void dissolve(String statements, double opaque) {
    Material m = material("Ka 1\nKd .8 .2 .1\nKs .25\n" + statements);
    assertEquals(Rgb.grey(1 - opaque), m.transparency());
    assertEquals(RED.times(opaque), m.diffuse());
    assertEquals(Rgb.grey(opaque), m.ambient());
    assertEquals(GREY, m.specular(), "a highlight stays");
    assertTrue(m.interior().isVacuum(), "straight on");
  }

  @Test
  void transmissionFilters() {
    assertEquals(Rgb.BLACK, material("Tf .5\nd 1\nillum 2").transparency(), "nothing goes through");
    assertEquals(new Rgb(0.05, 0.1, 0.2), material("Tf .1 .2 .4\nd .5").transparency());
    assertEquals(new Rgb(0.05, 0.1, 0.2), material("Kt .1 .2 .4\nd .5").transparency());
    assertEquals(new Rgb(0.05, 0.1, 0.2), material("Tf .1 .2 .4\nd .5\nillum 7").transparency());
    assertEquals(Rgb.WHITE, material("illum 7\nNi 1.5").transparency());
    assertEquals(Rgb.BLACK, material("illum 6\nKs 1.5").transparency());
  }

  @Test
  void dAndTrThatContradictEachOtherAreTold() {
    String told = "d and Tr contradict each other: d is taken, for Tr should be 1 - d";
    assertEquals(List.of("1:1: " + told), notes("newmtl a\nd 1\nTr 1\n"));
    assertEquals(
        List.of("1:1: " + told + " (2 times in this file)"),
        notes("newmtl a\nd .75\nTr .5\nnewmtl b\nTr .5\nd .75\n"));
    assertEquals(List.of(), notes("newmtl a\nd 0.333\nTr 0.667\nnewmtl b\nTr .5\n"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "newmtl a\nKd .8 .2 .1\n",
        "\uFEFFnewmtl a\nKd .8 .2 .1\n",
        "# c\n\n  newmtl   a  \n\tKd\t.8 .2 .1 # red\n",
        "newmtl a\r\nKd .8 .2 .1\r\n",
        "newmtl a\rKd .8 .2 .1\r",
        "newmtl a\nKd .8 \\\n .2 .1",
        "NEWMTL a\nkd .8 .2 .1",
        "newmtl a\nKd .8 .2 .1 1\n",
      })
  void linesAreReadAsInModels(String text) {
    for (Charset charset : List.of(StandardCharsets.UTF_8, StandardCharsets.UTF_16)) {
      MtlLibrary library =
          read(text.replace("\uFEFF", charset.name().length() > 5 ? "" : "\uFEFF"), charset);
      assertEquals(List.of(), library.problems());
      assertEquals(List.of(), library.notes());
      assertEquals(RED, library.materials().get("a").material().diffuse());
    }
  }

  @Test
  void namesMayHoldAlmostAnything() {
    String text =
        "newmtl a b\nnewmtl Material #25\nnewmtl\t c\\d \nnewmtl \\\n e \\\n  f\nnewmtl\n";
    assertEquals(Set.of("a b", "Material #25", "c\\d", "e f", ""), read(text).materials().keySet());
    assertEquals(Set.of("grün"), read("newmtl grün\n").materials().keySet());
    Charset latin = StandardCharsets.ISO_8859_1;
    assertEquals(
        Set.of("grün", "grön"), read("newmtl grün\nnewmtl grön", latin).materials().keySet());
    String longest = "x".repeat(1024);
    assertEquals(Set.of(longest), read("newmtl " + longest).materials().keySet());
  }

  @Test
  void theFirstOfANameCounts() {
    String text = "newmtl a\nKd 0\nnewmtl b\nKd 1\nnewmtl a\nKd 1\n";
    assertEquals(Rgb.BLACK, read(text).materials().get("a").material().diffuse());
    assertEquals(
        List.of("5:1: a material of this name stands before: this one is left out"), notes(text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Kd|2:3: Kd needs a number here",
        "Kd 1 2|2:7: Kd needs a number here",
        "Kd 1 2 x|2:8: expected a number, but found 'x'",
        "Kd 1 2 3 x|2:10: expected a number, but found 'x'",
        "Kd 1,5 0 0|2:4: expected a number, but found '1,5'; fractions follow a point",
        "Kd nan 0 0|2:4: not a finite number: 'nan'",
        "Kd 1 inf 0|2:6: not a finite number: 'inf'",
        "Kd -1 0 0|2:4: Kd must not be negative, infinite or NaN, but is (-1.0, 0.0, 0.0)",
        "Ks spectral a.rfl 1|2:4: colours are read as red, green and blue, not like this",
        "Ka xyz 1 1 1|2:4: colours are read as red, green and blue, not like this",
        "Ns -1|2:4: Ns must lie in 0.0 to 1.0E9, but is -1.0",
        "Ni x|2:4: expected a number, but found 'x'",
        "d 1.5|2:3: d must lie in 0.0 to 1.0, but is 1.5",
        "Tr -.5|2:4: Tr must lie in 0.0 to 1.0, but is -0.5",
        "illum 11|2:7: illum is a whole number from 0 to 10",
        "illum 1.5|2:7: illum is a whole number from 0 to 10",
        "map_Kd|2:1: map_Kd needs the name of an image",
        "map_Kd -s 1 2|2:1: map_Kd needs the name of an image",
        "map_Kd -s a.png|2:1: option -s of map_Kd needs a number",
        "map_Kd a.png -clamp|2:1: option -clamp of map_Kd needs a value",
        "map_Kd -s 1e7 a.png|2:1: map_Kd: scale must lie in -1000000.0 to 1000000.0, but is 1.0E7",
        "map_Kd -o 1 1e7 a.png|2:1: map_Kd: offset must lie in -1000000.0 to 1000000.0, but is 1.0E7",
        "map_Kd -mm 0 1e7 a.png|2:1: map_Kd: -mm must lie in -1000000.0 to 1000000.0, but is 1.0E7",
        "map_Kd a.png -bm 1 b|2:1: map_Kd has 'b' behind its options, which is none",
        "illum 7\\nNi 0|1:1: material 'a': ior must lie in 0.01 to 100.0, but is 0.0",
        "newmtl \\u0001|2:8: holds a control character (0x01): not a text file?",
      })
  void whatIsWrongIsToldWithItsPlace(String both) {
    String line = both.substring(0, both.indexOf('|')).replace("\\n", "\n");
    String text = "newmtl a\n" + line.replace("\\u0001", "\u0001") + "\nnewmtl b\n";
    MtlLibrary library = read(text);
    assertEquals(List.of(both.substring(both.indexOf('|') + 1)), lines(library.problems()));
    assertTrue(library.materials().isEmpty());
  }

  @Test
  void namesHaveAnEnd() {
    String told = "1:8: a name has up to 1024 characters";
    assertEquals(List.of(told), lines(read("newmtl " + "x".repeat(1025)).problems()));
    assertEquals(List.of(told), lines(read("newmtl " + "x".repeat(99_999)).problems()));
    String many = "newmtl " + "xxxxxxx \\\n".repeat(999) + "x";
    assertEquals(1, read(many).problems().size());
  }

  @Test
  void anIndexThatNothingBendsByIsNotAsked() {
    assertEquals(Rgb.WHITE, material("Ni 0\nillum 2").diffuse());
  }

  @Test
  void whatHasNoEffectIsToldOnce() {
    String text =
        "newmtl a\nmap_Bump b.png\nnorm -bm 3 n.png\nPr .2\nsharpness 60\nrefl x\nfoo\nBAR 1";
    assertEquals(
        List.of(
            "2:1: 'map_Bump' has no effect here (5 times in this file)",
            "7:1: 'foo' is not read: the line is left out (2 times in this file)"),
        notes(text));
    assertEquals(
        List.of("1:1: stands before the first newmtl: the line is left out (2 times in this file)"),
        notes("Kd 1 1 1\nNs 5\nnewmtl a\n"));
  }

  @Test
  void optionsOfAnImageWithoutEffectAreToldOnce() {
    String text = "newmtl a\nmap_Kd -bm 1 -t 1 a.png -blendu off\nnewmtl b\nmap_Kd -cc on a.png";
    assertEquals(List.of("2:1: '-bm' has no effect here (4 times in this file)"), notes(text));
    String used = "newmtl a\nmap_Kd -s 1 2 -o 1 -clamp off -mm 0 1 a.png";
    assertEquals(List.of(), notes(used));
  }

  @Test
  void whatIsUnlitHasNoImage() {
    String text = "newmtl a\nKd .5 .5 .5\nmap_Kd a.png\nillum 0";
    assertEquals(
        List.of("1:1: illum 0 shows Kd alone: the image of map_Kd is left out"), notes(text));
    assertFalse(read(text).materials().get("a").map().isPresent());
  }

  @Test
  void manyProblemsEndTheReading() {
    List<String> problems = lines(read("newmtl a\n" + "Kd\n".repeat(100_000)).problems());
    assertEquals(11, problems.size());
    assertTrue(problems.get(10).endsWith("reading ended there"), problems.get(10));
  }

  private static MtlMap map(String rest) {
    return only("map_Kd " + rest).map().orElseThrow();
  }

  @Test
  void anImageHasOptionsBeforeAndAfterItsName() {
    MtlMap plain = new MtlMap("a.png", 2, 1, Layout.ONCE, 0, 1);
    assertEquals(plain, map("a.png"));
    assertEquals(plain, map("  a.png  "));
    for (String noEffect :
        List.of(
            "-blendu on",
            "-blendv off",
            "-bm 1.5",
            "-boost 2",
            "-cc on",
            "-imfchan r",
            "-t 1 2 3",
            "-texres 512",
            "-type sphere",
            "-colorspace sRGB",
            "-clamp off",
            "-o 0",
            "-s 1 1 1",
            "-mm 0 1")) {
      assertEquals(plain, map(noEffect + " a.png"), noEffect);
      assertEquals(plain, map("a.png " + noEffect), noEffect);
    }
    Layout layout = new Layout(3, -4, 0.1, 0.2, Wrap.CLAMP);
    MtlMap all = new MtlMap("a.png", 2, 1, layout, 0.5, 2);
    assertEquals(all, map("-o .1 .2 -s 3 -4 5 -clamp on -mm .5 2 a.png"));
    assertEquals(all, map("-clamp on -o .1 .2 .3 a.png -s 3 -4 -mm .5 2"));
    assertEquals(0.1, map("-o .1 a.png").layout().offsetU());
    assertEquals(0, map("-o .1 a.png").layout().offsetV());
  }

  @Test
  void anImagesNameMayHoldBlanks() {
    assertEquals("texture 01.png", map("texture 01.png").file());
    assertEquals("01  b.png", map("-s 1 2 3 01  b.png").file());
    assertEquals("dir/my texture.png", map("-bm 2 dir\\my texture.png -clamp on").file());
    assertEquals("a -x #1.png", map("a -x #1.png").file());
    assertFalse(only("Kd 1").map().isPresent());
  }
}

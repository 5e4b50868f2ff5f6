package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Mesh;
import glint.geometry.MeshFacts;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each quirk of OBJ files in the wild that concerns geometry, in a small file of its own. */
class ObjReaderTest {

  private static final String FOUR = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  private static final List<Vector3d> TRIANGLE = List.of(v(0, 0, 0), v(1, 0, 0), v(1, 1, 0));

  private static Vector3d v(double x, double y, double z) {
    return new Vector3d(x, y, z);
  }

  /** O01. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "f 1 2 3",
        "f 1/1 2/1 3/1",
        "f 1//1 2//1 3//1",
        "f 1/1/1 2/1/1 3/1/1",
        "f 1 2/1 3/1/1",
        "f 1/ 2// 3/1/",
        "f 1/-1/-1 2//-1 3",
        "fo 1 2 3",
        "  f   1\t2  3  ",
        "f 1 2 3#comment",
        "f 1 2 3 # comment \\",
        "f 1 2 \\\n 3",
        "f \\\r\n1\\\r\n2 3",
        "f\\\n\\\n1 2 3\\",
        "f 1 2 \\ \t\n3",
        "f -4 -3 -2",
        "f 1 -3 3",
      })
  void formsOfFaces(String face) {
    String before = FOUR + "vt 0 0\nvn 0 0 1\n";
    assertEquals(TRIANGLE, ObjText.corners(before + face + "\n"));
    assertEquals(TRIANGLE, ObjText.corners(before + face));
    assertEquals(TRIANGLE, ObjText.corners((before + face + "\n").replaceAll("\r?\n", "\r\n")));
    assertEquals(TRIANGLE, ObjText.corners((before + face + "\n").replaceAll("\r?\n", "\r")));
  }

  /** O02. */
  @Test
  void negativeIndicesCountBackFromWhereTheyStand() {
    String text =
        """
        v 0 0 0
        v 1 0 0
        v 1 1 0
        f -3 -2 -1
        v 0 0 9
        v 1 0 9
        v 1 1 9
        f -3 -2 -1
        f -6 -5 -4
        """;
    List<Vector3d> expected = new ArrayList<>(TRIANGLE);
    TRIANGLE.forEach(p -> expected.add(p.plus(v(0, 0, 9))));
    expected.addAll(TRIANGLE);
    assertEquals(expected, ObjText.corners(text));
  }

  /** O03. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "f 0 1 2|5:3: index 0 in '0': the first is 1, and the last is -1",
        "f 1 2/0 3|5:5: index 0 in '2/0': the first is 1, and the last is -1",
        "f 1 2//-0 3|5:5: index 0 in '2//-0': the first is 1, and the last is -1",
        "f 1 2 5|5:7: no point 5: there are 4 points in the model",
        "f 1 -5 2|5:5: no point -5: there are 4 points before this",
        "f 1 2 99999999999999999999|5:7: no model has as many points as '99999999999999999999' needs",
        "f 1 2 3.0|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '3.0'",
        "f 1 2 x|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found 'x'",
        "f 1 2 -|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '-'",
        "f 1 2 /3|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '/3'",
        "f 1 2 3/1/1/1|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '3/1/1/1'",
        "f 1 2 3/x|5:7: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '3/x'",
        "f 1 2 \\n3 x|6:3: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found 'x'",
        "f 1 \\ 3|5:5: expected a corner such as 7, 7/2, 7//3 or 7/2/3, but found '\\'",
        "v 1 2|5:6: a point needs three numbers, but has only 2",
        "v|5:2: a point needs three numbers, but has only 0",
        "v 1 2 z|5:7: expected a number, but found 'z'",
        "v 1,5 2 3|5:3: expected a number, but found '1,5'; fractions follow a point",
        "v 1 2 3 1,5|5:9: expected a number, but found '1,5'; fractions follow a point",
        "v nan 1 2|5:3: not a finite number: 'nan'",
        "v 1 -NaN(ind) 2|5:5: not a finite number: '-NaN(ind)'",
        "v 1 inf 2|5:5: not a finite number: 'inf'",
        "v 1 2 -Infinity|5:7: not a finite number: '-Infinity'",
        "v 1 2 1.#QNAN|5:7: not a finite number: '1.#QNAN'",
        "v 1 2 1e999|5:7: too large a number: '1e999'",
        "v 1 0x10 2|5:5: expected a number, but found '0x10'",
        "v 1 2f 2|5:5: expected a number, but found '2f'",
        "\\tv 1 ü 2|5:6: expected a number, but found 'ü'",
      })
  void whatIsWrongIsToldWithItsPlace(String both) {
    String line = both.substring(0, both.indexOf('|'));
    String problem = both.substring(both.indexOf('|') + 1);
    String text = line.replace("\\n", "\\\n").replace("\\t", "\t");
    assertEquals(List.of(problem), ObjText.problems(FOUR + text));
    assertEquals(List.of(problem), ObjText.problems("\uFEFF" + FOUR + text + "\nf 1 2 3\n"));
    assertEquals(
        List.of(problem), ObjText.problems((FOUR + text + "\nf 1 2 3\n").replace("\n", "\r\n")));
  }

  @Test
  void everyStatementIsCheckedAndTenProblemsAreTold() {
    StringBuilder text = new StringBuilder("v 0 0 0\nv 1 0 0\nv x 0 0\nf 1 2 3\nf 3 -3 -2\n");
    assertEquals(List.of("3:3: expected a number, but found 'x'"), ObjText.problems("" + text));
    for (int i = 0; i < 20; i++) {
      text.append("f 1 2 0\n");
    }
    List<String> problems = ObjText.problems(text.toString());
    assertEquals(11, problems.size());
    assertEquals("6:7: index 0 in '0': the first is 1, and the last is -1", problems.get(1));
    assertEquals(" and 11 more problems, not shown", problems.get(10));
    for (int i = 0; i < 100_000; i++) {
      text.append("f 1 2 0\n");
    }
    problems = ObjText.problems(text.toString());
    assertEquals(" and 990 more problems, not shown; reading ended there", problems.get(10));
  }

  /** O05, but for the forms of faces above. */
  @Test
  void lineEndsBlanksAndComments() {
    String text =
        "# first\n\n  \t\nv 0 0 0 \nv\t1\t0\t0\t\n # comment \\\nv 1 1 0 # mid-line\nf 1 2 3 \n#";
    for (String end : new String[] {"\n", "\r\n", "\r", "\n\r"}) {
      assertEquals(TRIANGLE, ObjText.corners(text.replace("\n", end)));
      assertEquals(TRIANGLE, ObjText.corners("\uFEFF" + text.replace("\n", end)));
    }
    assertEquals(TRIANGLE, ObjText.corners(text.replace(' ', '\f').replace('\t', '\u000B')));
  }

  /** O06. */
  @Test
  void numbersDoNotDependOnTheLocale() {
    Locale before = Locale.getDefault();
    try {
      for (Locale locale : List.of(Locale.GERMANY, new Locale("ar", "EG"))) {
        Locale.setDefault(locale);
        List<Vector3d> c = ObjText.corners("v 1.5 .25 -2e+3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assertEquals(v(1.5, 0.25, -2000), c.get(0));
      }
    } finally {
      Locale.setDefault(before);
    }
  }

  /** A weight is meant for curves, not for polygons; colours are no geometry. */
  @Test
  void weightsAndColoursAfterThePointAreNoGeometry() {
    String text = "v 0 0 0 .5\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0 .5\nf 1 2 3\n";
    assertEquals(TRIANGLE, ObjText.corners(text));
    assertEquals(List.of(), ObjText.notes(text));
  }

  @Test
  void facesMayComeBeforeTheirPoints() {
    String text = "f 1 2 3\nf 1 2 3 4\n" + FOUR + "f 1 2 3\n";
    Mesh mesh = ObjText.mesh(text);
    assertEquals(4, mesh.triangles());
    assertEquals(2, MeshFacts.area(mesh), 0);
    assertEquals(
        List.of("1:7: no point 5: there are 4 points in the model"),
        ObjText.problems("f 1 2 5 9\n" + FOUR));
  }

  /** O09. */
  @Test
  void repeatedCornersAreDroppedAndCounted() {
    String text = FOUR + "f 1 1 2 3\nf 1 2 2 2 3 1 1\nf 1 2 3 4 1\nf 4 3 2\n";
    Mesh mesh = ObjText.mesh(text);
    assertEquals(5, mesh.triangles());
    assertEquals(2.5, MeshFacts.area(mesh), 0);
    assertEquals(
        List.of("5:1: a face repeats a corner, which is taken once (3 times in this file)"),
        ObjText.notes(text));
  }

  @Test
  void facesWithoutThreeCornersAreLeftOutAndCounted() {
    String text = FOUR + "f 1\nf\nf 1 2\nf 1 2 1\nf 2 2 2 2\nf 1 2 3\n";
    assertEquals(TRIANGLE, ObjText.corners(text));
    assertTrue(
        ObjText.notes(text)
            .contains(
                "5:1: a face needs three different corners: this one is left out"
                    + " (5 times in this file)"));
  }

  /** O13. */
  @ParameterizedTest
  @ValueSource(
      strings = {"", "\n", "# nothing", "\uFEFF", "v 1 2 3\n", "v 1 2 3\np 1\nl 1 1\n", "\\", "\r"})
  void filesWithoutFacesAreEmptyMeshes(String text) {
    assertEquals(0, ObjText.mesh(text).triangles());
    assertEquals(List.of(" holds no faces"), ObjText.notes(text));
  }

  @Test
  void whatIsNotGeometryIsPassedOver() {
    String text =
        """
        mtllib a b.mtl ..\\c.mtl
        mg 1 0
        o name with # in it
        g a b c
        s off
        usemtl none \\
          of these
        vp 0
        p 1 2
        l 1/1 2/2
        bevel on
        c_interp off
        d_interp off
        lod 1
        """;
    assertEquals(TRIANGLE, ObjText.corners(text + FOUR + "f 1 2 3\n"));
    assertEquals(List.of(), ObjText.notes(text + FOUR + "f 1 2 3\n"));
  }

  @Test
  void whatIsUnknownIsLeftOutAndCounted() {
    String text = FOUR + "f 1 2 3\nsurf 0 1 0 1 1 2\nF 1 2 3\nversion 1\n";
    assertEquals(
        List.of("6:1: 'surf' is not read: the line is left out (3 times in this file)"),
        ObjText.notes(text));
  }

  /** Coordinates beyond 1e100 are numbers, but no place for a triangle. */
  @Test
  void pointsFartherThanScenesReach() {
    String far = "v 1e308 0 0\n" + FOUR;
    assertEquals(TRIANGLE, ObjText.corners(far + "f 2 3 4\n"));
    assertEquals(
        List.of("6:5: coordinates reach 1e100, but those of this corner do not"),
        ObjText.problems(far + "f 2 1 3 4\n"));
    assertEquals(
        List.of("1:3: coordinates reach 1e100, but those of this corner do not"),
        ObjText.problems("f 1 2 3\n" + far));
  }

  /** Corners on a parabola, at whole numbers: the areas of all triangles are exact. */
  @Test
  void convexPolygonsOfAnySizeAreTwoTrianglesLess() {
    for (int n = 3; n < 60; n++) {
      StringBuilder text = new StringBuilder();
      StringBuilder face = new StringBuilder("f");
      double area = 0;
      for (long i = 0; i < n; i++) {
        text.append("v ").append(i).append(" 7 ").append(i * i).append('\n');
        face.append(' ').append(i + 1);
        long next = (i + 1) % n;
        area += 0.5 * (i * next * next - next * i * i);
      }
      Mesh mesh = ObjText.mesh(text.toString() + face);
      assertEquals(n - 2, mesh.triangles());
      assertEquals(Math.abs(area), MeshFacts.area(mesh), 0);
    }
  }

  @Test
  void polygonsKeepTheirSide() {
    String concave = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nf 1 2 3 4\nf 4 3 2 1\n";
    Mesh mesh = ObjText.mesh(concave);
    assertEquals(4, mesh.triangles());
    for (int i = 0; i < 4; i++) {
      List<Vector3d> c = MeshFacts.corners(mesh, i);
      Vector3d normal = c.get(1).minus(c.get(0)).cross(c.get(2).minus(c.get(0)));
      assertEquals(i < 2 ? 1 : -1, Math.signum(normal.z()));
    }
    assertEquals(3, MeshFacts.area(mesh), 0);
  }
}

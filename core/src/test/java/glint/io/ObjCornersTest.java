package glint.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import glint.geometry.Mesh;
import glint.geometry.MeshFacts;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Normals, texture points and smoothing groups of OBJ files. */
class ObjCornersTest {

  /** A square, and a wall that stands on its far edge. */
  private static final String SIX = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 2 2 2\nv 0 2 2\n";

  private static final Vector3d X = new Vector3d(1, 0, 0);
  private static final Vector3d Y = new Vector3d(0, 1, 0);
  private static final Vector3d Z = new Vector3d(0, 0, 1);

  private static List<Vector3d> normals(String text, int triangle) {
    return MeshFacts.normals(ObjText.mesh(SIX + text), triangle);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "vn 0 0 7\nvn 1e-300 0 0\nvn 0 .5 0 1\nf 1//1 2//2 3//3",
        "vt 0 0\nvn 0 0 1\nvn 1 0 0\nvn 0 1 0\nf 1/1/-3 2/1/-2 3/1/-1",
        "f 1//1 2//2 3//3\nvn 0 0 7\nvn 1 0 0\nvn 0 1 0",
        "f 1//1 1//3 2//2 2//1 3//3\nvn 0 0 7\nvn 1 0 0\nvn 0 1 0",
      })
  void cornersHaveTheNormalsThatTheyName(String text) {
    assertEquals(List.of(Z, X, Y), normals(text, 0));
  }

  /** Concave, so that its triangles are no fan. */
  @Test
  void dividedFacesKeepWhatTheirCornersHave() {
    StringBuilder text = new StringBuilder("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n");
    for (int i = 0; i < 4; i++) {
      text.append("vn ").append(i + 1).append(" 0 1\nvt ").append(i).append(" .5\n");
    }
    Mesh mesh = ObjText.mesh(text + "f 1/1/1 2/2/2 3/3/3 4/4/4\n");
    List<Vector3d> corners = ObjText.corners(mesh);
    List<Vector3d> points =
        List.of(Vector3d.ZERO, new Vector3d(4, 0, 0), new Vector3d(1, 1, 0), new Vector3d(0, 4, 0));
    for (int i = 0; i < 6; i++) {
      int which = points.indexOf(corners.get(i));
      Vector3d n = MeshFacts.normals(mesh, i / 3).get(i % 3);
      assertEquals(which + 1, n.x() / n.z(), 1e-15);
      assertEquals(which + ".0 0.5", MeshFacts.texture(mesh, i / 3).get(i % 3));
    }
  }

  /** O10. */
  @Test
  void cornersWithoutNormalAreFlatUnlessAnotherOfTheirFaceHasOne() {
    assertFalse(ObjText.mesh(SIX + "vn 0 0 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 2 4\n").isSmooth());
    String some = "vn 0 0 0\nvn 1 0 0\nf 1//1 2//2 3\nf 1 2 4\nf 1//2 2//2 4//2";
    assertEquals(List.of(Z, X, Z), normals(some, 0));
    assertEquals(List.of(), normals(some, 1));
    assertEquals(List.of(X, X, X), normals(some, 2));
  }

  @Test
  void normalsThatAreNoNumbersAreNoneAndCounted() {
    String text = SIX + "vn nan -nan 1\nvn 1.#IND 0 inf\nvn 1 0 0\nf 1//1 2//2 3//3\n";
    assertEquals(List.of(Z, Z, X), MeshFacts.normals(ObjText.mesh(text), 0));
    assertEquals(
        List.of("7:4: not a finite number: taken as no normal (2 times in this file)"),
        ObjText.notes(text));
  }

  @Test
  void facesOfOneSmoothingGroupShareNormals() {
    String square = "f 1 2 3 4\n";
    String wall = "f 4 3 5 6\n";
    Vector3d both = Z.minus(Y).normalized();
    assertEquals(List.of(), normals("s 0\n" + square + "s off\n" + wall, 0));
    List<Vector3d> shared = normals("s 1\n" + square + wall, 0);
    assertEquals(List.of(Z, Z), shared.subList(0, 2));
    assertEquals(0, shared.get(2).minus(both).length(), 1e-15);
    assertEquals(List.of(Z, Z, Z), normals("s 1\n" + square + "s 2\n" + wall, 0));
    assertEquals(List.of(), normals("s 1\n" + square + "s 2\n" + wall + "s off\nf 3 5 1\n", 4));
    // Faces that come before their points are in the group in which they stand.
    Mesh early = ObjText.mesh("s 1\n" + square + wall + "s off\n" + SIX);
    assertEquals(shared, MeshFacts.normals(early, 0));
    String odd = SIX + "s on\ns 1.5\ns\n" + square;
    assertFalse(ObjText.mesh(odd).isSmooth());
    assertEquals(
        List.of("7:3: neither a number nor off: no smoothing group (2 times in this file)"),
        ObjText.notes(odd));
  }

  /** Of the four corners at the edge, those of the square name a normal: the wall's have theirs. */
  @Test
  void givenNormalsAreNotShared() {
    String text = "vn 1 0 0\ns 1\nf 1//1 2//1 3//1 4//1\nf 4 3 5 6\n";
    assertEquals(List.of(X, X, X), normals(text, 0));
    for (Vector3d n : normals(text, 2)) {
      assertEquals(0, n.plus(Y).length());
    }
  }

  @Test
  void texturePoints() {
    Mesh mesh = ObjText.mesh(SIX + "vt .25\nvt 1e3 -1 9\nf 1/1 2/2/ 3\nf 1 2 3\n");
    assertEquals(List.of("0.25 0.0", "1000.0 -1.0", "-"), MeshFacts.texture(mesh, 0));
    assertEquals(List.of("-", "-", "-"), MeshFacts.texture(mesh, 1));
  }

  @Test
  void attributesOfManyTrianglesAndOfTheLastOnly() {
    StringBuilder text = new StringBuilder(SIX + "vn 1 0 0\nvt 3 4\n");
    for (int i = 0; i < 3000; i++) {
      text.append(i < 1500 ? "f 1 2 3\n" : "s 5\nf 1//1 2/1/1 3//1\n");
    }
    Mesh mesh = ObjText.mesh(text.toString());
    List<List<Vector3d>> first = new ArrayList<>();
    for (int i = 0; i < 1500; i++) {
      first.add(MeshFacts.normals(mesh, i));
    }
    assertEquals(java.util.Collections.nCopies(1500, List.of()), first);
    assertEquals(List.of(X, X, X), MeshFacts.normals(mesh, 1500));
    assertEquals(List.of("-", "3.0 4.0", "-"), MeshFacts.texture(mesh, 2999));
  }

  @Test
  void modelsMayBeStrippedOfTextureAndNormals() {
    String text = SIX + "f 1/1/1 2/2/1 3/3/1\n";
    assertEquals(1, ObjText.mesh(text).triangles());
    assertEquals(
        List.of(
            "7:3: a corner names a texture point or normal, but the model has none"
                + " (6 times in this file)"),
        ObjText.notes(text));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "vn 1 2|7:7: a normal needs three numbers, but has only 2",
        "vn 1 2 x|7:8: expected a number, but found 'x'",
        "vt|7:3: a texture point needs a number",
        "vt nan 1|7:4: not a finite number: 'nan'",
        "vt 0\nf 1/1 2/2 3|8:7: no texture point 2: there is 1 texture point in the model",
        "f 1//-1 2 3|7:3: no normal -1: there are 0 normals before this",
        "vn 0 0 1\nf 1//1 2 3//7|8:10: no normal 7: there is 1 normal in the model",
      })
  void whatIsWrongIsToldWithItsPlace(String both) {
    String line = both.substring(0, both.indexOf('|')).replace("\\n", "\n");
    assertEquals(
        List.of(both.substring(both.indexOf('|') + 1)), ObjText.problems(SIX + line + "\n"));
  }
}

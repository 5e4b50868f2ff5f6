package glint.io;

import glint.geometry.Mesh;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Reads the polygons of Wavefront OBJ files (Wavefront, Advanced Visualizer Manual, appendix B1),
 * quirks of the wild included (docs/scene-format.md).
 *
 * <p>Points, texture points, normals, smoothing groups, faces and the names of materials are read;
 * points and lines to be drawn and other groups are known and passed over. One pass, and memory in
 * proportion to the mesh.
 */
public final class ObjReader {

  /** How many problems of a model are told. */
  private static final int MOST_PROBLEMS = 10;

  /** What holds no geometry that a polygon mesh could lack. */
  private static final Set<String> PASSED_OVER =
      Set.of(
          "vp",
          "vw",
          "p",
          "l",
          "g",
          "o",
          "mg",
          "usemap",
          "maplib",
          "bevel",
          "c_interp",
          "d_interp",
          "lod",
          "shadow_obj",
          "trace_obj",
          "t");

  private final ObjSource source;
  private final Problems problems;
  private final Problems notes;
  private final ObjGeometry geometry = new ObjGeometry();
  private final ObjParts parts = new ObjParts();
  private final ObjFaces faces = new ObjFaces(geometry, parts);

  /** What follows each {@code mtllib}: one name or several. */
  private final Map<String, ObjName> libraries = new LinkedHashMap<>();

  private final double[] numbers = new double[3];
  private ObjNote unknown;
  private final ObjNote noNormal = new ObjNote("not a finite number: taken as no normal");
  private final ObjNote noGroup = new ObjNote("neither a number nor off: no smoothing group");

  private ObjReader(InputStream in, String name) throws IOException {
    source = new ObjSource(in);
    problems = new Problems(name, MOST_PROBLEMS);
    notes = new Problems(name, MOST_PROBLEMS);
  }

  /**
   * Reads one model.
   *
   * <p>Whatever is wrong with the content becomes a problem and never an exception.
   *
   * @param in the bytes; left open
   * @param name the file's name or path, which begins every message
   * @throws IOException if the stream fails
   */
  public static ObjModel read(InputStream in, String name) throws IOException {
    return new ObjReader(in, name).model();
  }

  private ObjModel model() throws IOException {
    try {
      readStatements();
      faces.finish(problems, notes);
    } catch (Problems.TooMany e) {
      // They have been told
    }
    if (problems.reports() > 0) {
      return new ObjModel(null, List.of(), List.of(), problems.inFileOrder(), List.of());
    }
    if (unknown != null) {
      unknown.report(notes);
    }
    noNormal.report(notes);
    noGroup.report(notes);
    if (geometry.triangleCount() == 0) {
      notes.report(Place.NONE, "holds no faces");
    }
    List<ObjName> named = new ArrayList<>(libraries.values());
    List<ObjName> materials = parts.used();
    Mesh mesh = parts.divide(geometry.mesh());
    return new ObjModel(mesh, materials, named, List.of(), notes.inFileOrder());
  }

  private void readStatements() throws IOException {
    while (!source.isAtEnd()) {
      try {
        if (source.hasToken()) {
          readStatement();
        }
      } catch (BadObj e) {
        problems.report(e.place(), e.getMessage());
        if (e.hopeless()) {
          return;
        }
      }
      source.endStatement();
    }
  }

  private void readStatement() throws IOException {
    int line = source.line();
    int column = source.column();
    if (source.takes("v")) {
      readPoint();
    } else if (source.takes("vn")) {
      readNormal();
    } else if (source.takes("vt")) {
      readTexturePoint();
    } else if (source.takes("s")) {
      readGroup();
    } else if (source.takes("f") || source.takes("fo")) {
      faces.begin(line, column);
      readFace();
    } else if (source.takes("usemtl")) {
      parts.use(name());
    } else if (source.takes("mtllib")) {
      ObjName library = name();
      libraries.putIfAbsent(library.text(), library);
    } else {
      passOver();
    }
  }

  /** Reads a point; a weight or a colour after its coordinates is only checked to be numbers. */
  private void readPoint() throws IOException {
    try {
      readNumbers("a point", 3);
    } finally {
      // A bad one counts, so that the indices after it stay right
      geometry.point(numbers[0], numbers[1], numbers[2]);
    }
  }

  /** Reads a normal; one that is no finite number, as of a face without area, is no normal. */
  private void readNormal() throws IOException {
    try {
      readNumbers("a normal", 3);
    } catch (BadObj e) {
      if (!e.isNotFinite()) {
        throw e;
      }
      noNormal.at(e.place());
      Arrays.fill(numbers, 0);
    } finally {
      geometry.normals.add(numbers);
    }
  }

  private void readTexturePoint() throws IOException {
    try {
      readNumbers("a texture point", 1);
    } finally {
      geometry.textures.add(numbers);
    }
  }

  /** Reads three numbers, some of which must be there; the others are 0. Checks what follows. */
  private void readNumbers(String what, int least) throws IOException {
    Arrays.fill(numbers, 0);
    for (int i = 0; source.hasToken() || i < least; i++) {
      if (!source.hasToken()) {
        String needs = least == 1 ? " needs a number" : " needs three numbers, but has only " + i;
        throw new BadObj(source.place(), what + needs);
      }
      double v = source.number();
      if (i < 3) {
        numbers[i] = v;
      }
    }
  }

  private void readGroup() throws IOException {
    int group = 0;
    if (source.hasToken() && !source.takes("off")) {
      Place place = source.place();
      try {
        double v = source.number();
        group = (int) v;
        if (group != v) {
          noGroup.at(place);
        }
      } catch (BadObj e) {
        if (e.hopeless()) {
          throw e;
        }
        noGroup.at(place);
      }
    }
    faces.smooth(group);
  }

  private void readFace() throws IOException {
    while (source.hasToken()) {
      int line = source.line();
      int column = source.column();
      source.corner();
      faces.corner(source.index(0), source.index(1), source.index(2), line, column);
    }
    faces.end();
  }

  private ObjName name() throws IOException {
    source.hasToken(); // goes there, or to the end of the line
    int line = source.line();
    int column = source.column();
    return new ObjName(source.rest(), line, column);
  }

  private void passOver() {
    String word = source.word();
    if (!PASSED_OVER.contains(word)) {
      if (unknown == null) {
        String what = SourceText.quote(word) + " is not read: the line is left out";
        unknown = new ObjNote(what);
      }
      unknown.at(source.place());
    }
  }
}

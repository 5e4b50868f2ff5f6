package glint.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * Reads the polygons of Wavefront OBJ files (Wavefront, Advanced Visualizer Manual, appendix B1),
 * quirks of the wild included (docs/scene-format.md).
 *
 * <p>Points and faces are read; points and lines to be drawn, texture coordinates, normals, groups
 * and materials are known and passed over. One pass, and memory in proportion to the mesh.
 */
public final class ObjReader {

  /** How many problems of a model are told. */
  private static final int MOST_PROBLEMS = 10;

  /** What holds no geometry that a polygon mesh could lack. */
  private static final Set<String> PASSED_OVER =
      Set.of(
          "vn",
          "vt",
          "vp",
          "vw",
          "p",
          "l",
          "g",
          "o",
          "s",
          "mg",
          "usemtl",
          "mtllib",
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
  private final ObjFaces faces = new ObjFaces(geometry);
  private final double[] point = new double[3];
  private ObjNote unknown;

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
      return new ObjModel(null, problems.inFileOrder(), List.of());
    }
    if (unknown != null) {
      unknown.report(notes);
    }
    if (geometry.triangleCount() == 0) {
      notes.report(Place.NONE, "holds no faces");
    }
    return new ObjModel(geometry.mesh(), List.of(), notes.inFileOrder());
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
    } else if (source.takes("vn") || source.takes("vt")) {
      return;
    } else if (source.takes("f") || source.takes("fo")) {
      faces.begin(line, column);
      readFace();
    } else {
      passOver();
    }
  }

  /** Reads a point; a weight or a colour after its coordinates is only checked to be numbers. */
  private void readPoint() throws IOException {
    Arrays.fill(point, 0);
    try {
      for (int i = 0; i < 3; i++) {
        if (!source.hasToken()) {
          throw new BadObj(source.place(), "a point needs three numbers, but has only " + i);
        }
        point[i] = source.number();
      }
      while (source.hasToken()) {
        source.number();
      }
    } finally {
      // A bad one counts, so that the indices after it stay right
      geometry.point(point[0], point[1], point[2]);
    }
  }

  private void readFace() throws IOException {
    while (source.hasToken()) {
      int line = source.line();
      int column = source.column();
      source.corner();
      faces.corner(source.vertex(), line, column);
    }
    faces.end();
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

package glint.io;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.math.Check;
import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Reads the materials of Wavefront MTL files (Wavefront, Advanced Visualizer Manual, appendix B1),
 * quirks of the wild included (docs/scene-format.md).
 */
public final class MtlReader {

  /** How many problems of a file are told. */
  private static final int MOST_PROBLEMS = 10;

  /** What is known, but describes nothing that is rendered. */
  private static final Set<String> WITHOUT_EFFECT =
      Set.of(
          "map_ka",
          "map_ks",
          "map_ke",
          "map_ns",
          "map_ni",
          "map_d",
          "map_tr",
          "map_bump",
          "bump",
          "map_disp",
          "disp",
          "decal",
          "refl",
          "map_refl",
          "norm",
          "map_norm",
          "map_aat",
          "sharpness",
          "pr",
          "pm",
          "ps",
          "pc",
          "pcr",
          "aniso",
          "anisor",
          "map_pr",
          "map_pm",
          "map_ps",
          "map_pc",
          "map_pcr",
          "map_rma",
          "map_orm");

  private static final String WITHOUT = " has no effect here";

  private static final Set<String> KNOWN =
      Set.of(
          "newmtl", "ka", "kd", "ks", "ke", "tf", "kt", "ns", "ni", "d", "tr", "illum", "map_kd");

  private final ObjSource source;
  private final Problems problems;
  private final Problems notes;
  private final Map<String, MtlMaterial> materials = new HashMap<>();
  private final ObjNote homeless =
      new ObjNote("stands before the first newmtl: the line is left out");
  private final ObjNote repeated =
      new ObjNote("a material of this name stands before: this one is left out");
  private final ObjNote contradictory =
      new ObjNote("d and Tr contradict each other: d is taken, for Tr should be 1 - d");
  private final ObjNote unlit =
      new ObjNote("illum 0 shows Kd alone: the image of map_Kd is left out");
  private ObjNote unknown;
  private ObjNote ineffective;

  /** The material that is being read, and where it began; null before the first. */
  private MtlDraft draft;

  private String name;
  private Place begun;

  private MtlReader(InputStream in, String fileName) throws IOException {
    source = new ObjSource(in);
    problems = new Problems(fileName, MOST_PROBLEMS);
    notes = new Problems(fileName, MOST_PROBLEMS);
  }

  /**
   * Reads one library of materials.
   *
   * <p>Whatever is wrong with the content becomes a problem and never an exception.
   *
   * @param in the bytes; left open
   * @param name the file's name or path, which begins every message
   * @throws IOException if the stream fails
   */
  public static MtlLibrary read(InputStream in, String name) throws IOException {
    return new MtlReader(in, name).library();
  }

  private MtlLibrary library() throws IOException {
    try {
      readStatements();
    } catch (Problems.TooMany e) {
      // They have been told
    }
    finishMaterial();
    for (ObjNote note :
        new ObjNote[] {homeless, repeated, contradictory, unlit, unknown, ineffective}) {
      if (note != null) {
        note.report(notes);
      }
    }
    boolean sound = problems.reports() == 0;
    List<Problem> remarks = sound ? notes.inFileOrder() : List.of();
    return new MtlLibrary(sound ? materials : Map.of(), problems.inFileOrder(), remarks);
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
    Place place = source.place();
    String written = source.word();
    String word = written.toLowerCase(Locale.ROOT);
    if (WITHOUT_EFFECT.contains(word)) {
      ineffective = noted(ineffective, written, WITHOUT, place);
    } else if (!KNOWN.contains(word)) {
      unknown = noted(unknown, written, " is not read: the line is left out", place);
    } else if (draft == null && !word.equals("newmtl")) {
      homeless.at(place);
    } else if (source.takes(written)) {
      source.hasToken(); // goes there, or to the end of the line
      obey(written, word, place);
    }
  }

  private static ObjNote noted(ObjNote before, String word, String what, Place place) {
    ObjNote note = before != null ? before : new ObjNote(SourceText.quote(word) + what);
    note.at(place);
    return note;
  }

  private void obey(String written, String word, Place place) throws IOException {
    switch (word) {
      case "newmtl" -> begin(place);
      case "ka" -> draft.ambient = color(written);
      case "kd" -> draft.diffuse = color(written);
      case "ks" -> draft.specular = color(written);
      case "ke" -> draft.emission = color(written);
      case "tf", "kt" -> draft.filter = color(written);
      case "ns" -> draft.shininess = number(written, 0, 1e9);
      case "ni" -> draft.index = number(written, 0, 1e9);
      case "d" -> draft.dissolve = dissolve(written);
      case "tr" -> draft.transparency = number(written, 0, 1);
      case "illum" -> draft.model = model(written);
      default ->
          draft.map =
              MtlMapReader.read(
                  source.rest(),
                  place,
                  option -> ineffective = noted(ineffective, option, WITHOUT, place));
    }
    while (source.hasToken()) { // more than is needed must be numbers
      source.number();
    }
  }

  private void begin(Place place) throws IOException {
    finishMaterial();
    draft = new MtlDraft();
    begun = place;
    name = source.rest();
  }

  private void finishMaterial() {
    if (draft == null) {
      return;
    }
    if (draft.contradictsItself()) {
      contradictory.at(begun);
    }
    if (draft.leavesOutMap()) {
      unlit.at(begun);
    }
    try {
      if (materials.putIfAbsent(name, draft.finish()) != null) {
        repeated.at(begun);
      }
    } catch (BadValueException e) {
      problems.report(begun, "material " + SourceText.quote(name) + ": " + e.getMessage());
    }
  }

  /** Reads three numbers, or one for grey. */
  private Rgb color(String word) throws IOException {
    Place place = source.place();
    if (source.takes("spectral") || source.takes("xyz")) {
      throw new BadObj(place, "colours are read as red, green and blue, not like this");
    }
    double r = number(word);
    if (!source.hasToken()) {
      return checked(place, word, r, r, r);
    }
    double g = number(word);
    source.hasToken();
    return checked(place, word, r, g, number(word));
  }

  private static Rgb checked(Place place, String word, double r, double g, double b) {
    Rgb color = new Rgb(r, g, b);
    try {
      color.requireLight(word);
    } catch (BadValueException e) {
      throw new BadObj(place, e.getMessage());
    }
    return color;
  }

  /**
   * Reads how opaque a surface is; a halo, which is more so at its rim, is read as if it were not.
   */
  private double dissolve(String word) throws IOException {
    source.takes("-halo");
    source.hasToken();
    return number(word, 0, 1);
  }

  private int model(String word) throws IOException {
    Place place = source.place();
    double model = number(word);
    if (model != Math.rint(model) || model < 0 || model > MtlDraft.LAST_MODEL) {
      throw new BadObj(place, "illum is a whole number from 0 to 10");
    }
    return (int) model;
  }

  private double number(String word, double least, double most) throws IOException {
    Place place = source.place();
    double value = number(word);
    try {
      Check.range(word, value, least, most);
    } catch (BadValueException e) {
      throw new BadObj(place, e.getMessage());
    }
    return value;
  }

  private double number(String word) throws IOException {
    if (!source.hasToken()) {
      throw new BadObj(source.place(), word + " needs a number here");
    }
    return source.number();
  }
}

package glint.io;

import glint.optics.Material;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Finds the materials of a model's parts in the libraries that it names. */
final class ModelMaterials {

  /** More are not looked for. */
  private static final int MOST_LIBRARIES = 1000;

  private static final int MOST_NOTES = 10;

  private final SceneFolder folder;
  private final Beside beside;
  private final Images images;
  private final Problems remarks;
  private final Map<String, Known> known = new HashMap<>();

  /** Those that parts are made of, with their images. */
  private final Map<String, Material> finished = new HashMap<>();

  private final Set<String> read = new HashSet<>();
  private final List<ModelLibrary> libraries = new ArrayList<>();
  private final List<ModelPart> parts = new ArrayList<>();
  private final List<Problem> problems = new ArrayList<>();
  private final List<Problem> notes = new ArrayList<>();
  private boolean complete = true;

  /** A material and the library that it comes from. */
  private record Known(MtlMaterial material, ModelLibrary library) {}

  /**
   * Reads the libraries that the parts of a model need, and their images.
   *
   * @param path the model's, from the folder
   */
  ModelMaterials(ObjModel model, String path, SceneFolder folder, Images images) {
    this.folder = folder;
    this.images = images;
    beside = new Beside(folder, path);
    remarks = new Problems(folder.name(path), MOST_NOTES);
    if (model.materials().stream().anyMatch(name -> name.line() > 0)) {
      model.libraries().stream().limit(MOST_LIBRARIES).forEach(this::open);
    }
    findParts(model.materials());
    notes.addAll(0, remarks.inFileOrder());
    libraries.forEach(library -> notes.addAll(library.notes()));
  }

  /** Returns what the parts are made of. */
  List<ModelPart> parts() {
    return parts;
  }

  /** Returns what is wrong within the libraries. */
  List<Problem> problems() {
    return problems;
  }

  /** Returns what is missing or was left out. */
  List<Problem> notes() {
    return notes;
  }

  /** Opens what one statement names: one file, or if that is not there, several. */
  private void open(ObjName statement) {
    // A backslash stands before a blank that belongs to a name, or for a slash.
    String text = statement.text().replace('\t', ' ').replace("\\ ", " ").replace('\\', '/');
    List<String> names = split(text);
    if (names.size() > 1 && read(text) == null) {
      return;
    }
    for (String name : names) {
      String reason = read(name);
      if (reason != null) {
        replace(name, reason, statement.place());
      }
    }
  }

  /** Divides names: one ends with a word that ends in .mtl, or with the line. */
  private static List<String> split(String text) {
    List<String> names = new ArrayList<>();
    StringBuilder name = new StringBuilder();
    for (String word : text.split(" ")) {
      name.append(name.length() == 0 ? "" : " ").append(word);
      if (word.toLowerCase(Locale.ROOT).endsWith(".mtl")) {
        names.add(name.toString().trim());
        name.setLength(0);
      }
    }
    if (name.length() > 0) {
      names.add(name.toString().trim());
    }
    return names;
  }

  /** Reads a library, unless that is done; returns why it could not be read, or null. */
  private String read(String name) {
    if (read.contains(name)) {
      return null;
    }
    try (InputStream in = beside.open(name)) {
      MtlLibrary library = MtlReader.read(in, beside.name(name));
      read.add(name);
      ModelLibrary from = new ModelLibrary(folder, beside.path(name), images, MOST_NOTES);
      libraries.add(from);
      library.materials().forEach((each, m) -> known.putIfAbsent(each, new Known(m, from)));
      problems.addAll(library.problems());
      complete &= library.problems().isEmpty();
      notes.addAll(library.notes());
      return null;
    } catch (IOException e) {
      return e.getMessage();
    }
  }

  /** Takes a library of the same name beside the model, for one on somebody's own disk. */
  private void replace(String name, String reason, Place place) {
    String last = name.substring(name.lastIndexOf('/') + 1);
    String missing = "material library " + SourceText.quote(name) + " cannot be read: " + reason;
    if (!last.equals(name) && read(last) == null) {
      remarks.report(place, missing + "; " + SourceText.quote(last) + " is taken instead");
    } else {
      complete = false;
      remarks.report(place, missing);
    }
  }

  private void findParts(List<ObjName> names) {
    ObjName lost = null;
    int count = 0;
    for (ObjName name : names) {
      Material material = find(name.text());
      parts.add(new ModelPart(name.text(), Optional.ofNullable(material)));
      if (material == null && name.line() > 0) {
        lost = lost == null ? name : lost;
        count++;
      }
    }
    if (lost != null && complete) { // or what is missing has been told
      String others = count == 1 ? "" : ", nor are " + (count - 1) + " others";
      remarks.report(
          lost.place(),
          "material "
              + SourceText.quote(lost.text())
              + " is in no library of this model"
              + others
              + ": the default material is taken");
    }
  }

  /** Returns the material of a name, which a comment may follow: it may hold a # of its own. */
  private Material find(String name) {
    Material material = finished(name);
    for (int end = comment(name, name.length()); end >= 0 && material == null; ) {
      material = finished(name.substring(0, end).trim());
      end = comment(name, end - 1);
    }
    return material;
  }

  private Material finished(String name) {
    Known found = known.get(name);
    return found == null
        ? null
        : finished.computeIfAbsent(name, any -> found.library().finished(found.material()));
  }

  private static int comment(String name, int before) {
    return name.lastIndexOf(" #", before);
  }
}

package glint.io;

import glint.geometry.Mesh;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The materials that a model's faces name, and which triangles are of which. */
final class ObjParts {

  /** What faces before any {@code usemtl} are of. */
  private static final ObjName NONE = new ObjName("", 0, 0);

  /** Every name that was met, where it first was, in order. */
  private final List<ObjName> names = new ArrayList<>();

  private final Map<String, Integer> numbers = new HashMap<>();
  private int current;

  /** The first triangle of each run of triangles of one name, and its name's number. */
  private final Ints starts = new Ints();

  private final Ints runs = new Ints();

  ObjParts() {
    names.add(NONE);
  }

  /** Faces from here on are of a material. */
  void use(ObjName material) {
    current =
        numbers.computeIfAbsent(
            material.text(),
            text -> {
              names.add(material);
              return names.size() - 1;
            });
  }

  /** Returns the number of the material that faces are of now. */
  int current() {
    return current;
  }

  /** Triangles from a number on are of a material. */
  void begin(int triangle, int material) {
    int count = runs.size();
    if (count == 0 || runs.get(count - 1) != material) {
      starts.add(triangle);
      runs.add(material);
    }
  }

  /** Returns the names that triangles are of, in the order of their numbers as parts. */
  List<ObjName> used() {
    Set<ObjName> used = new LinkedHashSet<>();
    for (int i = 0; i < runs.size(); i++) {
      used.add(names.get(runs.get(i)));
    }
    return used.isEmpty() ? List.of(NONE) : new ArrayList<>(used);
  }

  /** Returns the mesh in its parts; ends the use of this. */
  Mesh divide(Mesh mesh) {
    if (runs.size() < 2) {
      return mesh;
    }
    int[] number = new int[names.size()];
    Arrays.fill(number, -1);
    int used = 0;
    int[] parts = runs.toArray();
    for (int i = 0; i < parts.length; i++) {
      if (number[parts[i]] < 0) {
        number[parts[i]] = used++;
      }
      parts[i] = number[parts[i]];
    }
    return mesh.inParts(starts.toArray(), parts);
  }
}

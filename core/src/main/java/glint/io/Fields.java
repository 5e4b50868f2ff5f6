package glint.io;

import glint.color.Rgb;
import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.math.BadValueException;
import glint.math.Vector3d;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

/** One map of a scene file: its keys checked against its section, its values by key. */
final class Fields {

  private final Section section;
  private final YamlNode node;
  private final Values values;
  private final Map<String, YamlNode> written = new HashMap<>();
  private final Set<String> misspelt = new HashSet<>();
  private final long reportsBefore;
  private boolean usesLater;

  /** Reports a node that is no map, and keys that are unknown, unsupported or given twice. */
  Fields(YamlNode node, Section section, Values values) {
    this.node = node;
    this.section = section;
    this.values = values;
    reportsBefore = values.problems().reports();
    if (!(node instanceof Mapping map)) {
      values.wrong(node, section.form());
      return;
    }
    for (Map.Entry<String, Entry> each : Keyed.of(map, values).first().entrySet()) {
      if (section.keys().contains(each.getKey())) {
        written.put(each.getKey(), each.getValue().value());
      } else {
        reportUnknown(each.getKey(), each.getValue().key());
      }
    }
  }

  /** Returns the one entry of a map that says of what kind something is, or null. */
  static Entry kind(YamlNode node, Section section, Values values) {
    if (!(node instanceof Mapping map) || map.entries().isEmpty()) {
      values.wrong(node, section.form());
      return null;
    }
    Keyed keyed = Keyed.of(map, values);
    if (keyed.first().size() > 1) {
      List<Entry> entries = new ArrayList<>(keyed.first().values());
      values.report(
          entries.get(1).key(),
          "expected one "
              + section.noun()
              + " in a list item, but found "
              + String.join(" beside ", quoted(keyed.first().keySet()))
              + ": check the indentation");
      return null;
    }
    Fields fields = new Fields(node, section, values);
    return fields.isSound() && !fields.written.isEmpty() ? map.entries().get(0) : null;
  }

  private static List<String> quoted(Set<String> keys) {
    List<String> quoted = new ArrayList<>();
    for (String key : keys) {
      quoted.add(SourceText.quote(key));
    }
    return quoted.subList(0, 2);
  }

  private void reportUnknown(String key, YamlNode place) {
    String quoted = SourceText.quote(key);
    if (section.later().contains(key)) {
      usesLater = true;
      values.report(
          place,
          quoted + " is part of the scene format, but this version of Glint cannot render it yet");
      return;
    }
    List<String> possible = new ArrayList<>(section.keys());
    possible.addAll(section.later());
    String meant = Suggestion.nearest(key, possible);
    if (meant != null) {
      misspelt.add(meant);
    }
    String hint =
        meant == null
            ? Suggestion.hintOrList(key, section.keys())
            : "; did you mean '" + meant + "'?";
    String what =
        section.namesKinds()
            ? section.noun() + " " + quoted
            : "key " + quoted + " in " + section.title();
    values.report(place, "unknown " + what + hint);
  }

  /** Returns whether nothing was reported since this map was begun. */
  boolean isSound() {
    return values.problems().reports() == reportsBefore;
  }

  boolean has(String key) {
    return get(key) != null;
  }

  /** Returns whether a key is written, or seems to be meant by one that is misspelt. */
  boolean means(String key) {
    return has(key) || misspelt.contains(key);
  }

  /** Returns the value of a key, or null if it is not written. */
  YamlNode get(String key) {
    if (!section.keys().contains(key)) {
      throw new IllegalArgumentException(section + " has no key " + key);
    }
    return written.get(key);
  }

  /** Returns the value of a key, or null with a problem reported if it is not written. */
  YamlNode need(String key) {
    YamlNode value = get(key);
    boolean replaced = usesLater || misspelt.contains(key);
    if (value == null && node instanceof Mapping && !replaced) {
      values.report(node, section.title() + " needs '" + key + "'");
    }
    return value;
  }

  double number(String key) {
    return values.number(need(key));
  }

  double number(String key, double absent) {
    return has(key) ? number(key) : absent;
  }

  Vector3d vector(String key) {
    return values.vector(need(key));
  }

  Rgb light(String key) {
    return values.light(key, need(key));
  }

  Rgb light(String key, Rgb absent) {
    return has(key) ? light(key) : absent;
  }

  Rgb coefficients(String key, Rgb absent) {
    return has(key) ? values.coefficients(key, get(key)) : absent;
  }

  int wholeNumber(String key, int absent) {
    return has(key) ? values.wholeNumber(get(key)) : absent;
  }

  boolean flag(String key, boolean absent) {
    return has(key) ? values.flag(get(key)) : absent;
  }

  /** Returns one of some words, of which the first is the default. */
  String word(String key, String... possible) {
    return has(key) ? values.word(get(key), List.of(possible)) : possible[0];
  }

  /** Notes why keys have no effect, those that are written. */
  void noteIdle(String why, String... keys) {
    for (String key : keys) {
      if (has(key)) {
        values.note(get(key), "'" + key + "' " + why);
      }
    }
  }

  /**
   * Returns what the supplier makes of this map's values if they are all sound, else null.
   *
   * <p>A value that it finds bad is reported where the value stands, or else where the map does.
   */
  <T> T build(Supplier<T> supplier) {
    if (!isSound()) {
      return null;
    }
    try {
      return supplier.get();
    } catch (BadValueException e) {
      YamlNode value = written.get(e.field());
      values.report(value == null ? node : value, e.getMessage());
      return null;
    }
  }
}

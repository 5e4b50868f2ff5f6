package glint.io;

import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.io.YamlNode.Scalar;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The entries of a map by key; keys that are no text and repeated keys are reported.
 *
 * @param first the first entry of each key, in file order
 * @param repeated the keys that were given more than once
 */
record Keyed(Map<String, Entry> first, Set<String> repeated) {

  static Keyed of(Mapping map, Values values) {
    Map<String, Entry> first = new LinkedHashMap<>();
    Set<String> repeated = new HashSet<>();
    for (Entry entry : map.entries()) {
      if (!(entry.key() instanceof Scalar key) || key.isNull()) {
        values.report(entry.key(), "expected a key, but found " + entry.key().described());
        continue;
      }
      Entry before = first.putIfAbsent(key.text(), entry);
      if (before != null) {
        repeated.add(key.text());
        String name = SourceText.quote(key.text());
        values.report(key, name + " is already given at " + before.key().place());
      }
    }
    return new Keyed(first, repeated);
  }
}

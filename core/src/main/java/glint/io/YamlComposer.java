package glint.io;

import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.io.YamlNode.Scalar;
import glint.io.YamlNode.Sequence;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.api.lowlevel.Parse;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;

/**
 * Composes the one document of a YAML text into nodes that know their places.
 *
 * <p>An alias becomes the node that it names. Depth and size are bounded, the size as if every
 * alias were written out, so that walking the nodes takes bounded time.
 */
final class YamlComposer {

  /** The most values of a file, aliases written out. */
  static final int MOST_NODES = 5_000_000;

  /** The deepest nesting of lists and maps. */
  static final int DEEPEST = 64;

  /**
   * Characters that the engine reads at a time. A token longer than that is copied once for each
   * time, so that a small number would make the reading of a long token take quadratic time.
   */
  private static final int BUFFER = 1 << 20;

  /** An anchored node, null while it is still open, and its size with aliases written out. */
  private record Anchored(YamlNode node, long size) {}

  private final Map<String, Anchored> anchors = new HashMap<>();
  private final Iterator<Event> events;
  private Place reached = new Place(1, 1);
  private long size;

  private YamlComposer(String text) {
    LoadSettings settings =
        LoadSettings.builder()
            .setBufferSize(Math.min(text.length() + 1, BUFFER))
            .setCodePointLimit(SourceText.MOST_BYTES)
            .build();
    events = new Parse(settings).parseString(text).iterator();
  }

  /** Returns the root of the document, or null with a problem reported. */
  static YamlNode compose(String text, Problems problems) {
    YamlComposer composer = new YamlComposer(text);
    try {
      return composer.document();
    } catch (Unreadable e) {
      problems.report(e.place, e.getMessage());
    } catch (MarkedYamlEngineException e) {
      YamlErrors.report(e, problems);
    } catch (YamlEngineException | IllegalArgumentException e) {
      // The engine lets a few of Java's own exceptions through, such as that of "\UFFFFFFFF".
      problems.report(composer.reached, "is not YAML 1.2 from here on");
    }
    return null;
  }

  private YamlNode document() {
    next();
    Event begin = next();
    if (begin.getEventId() == Event.ID.StreamEnd) {
      throw new Unreadable(new Place(1, 1), "the file is empty: a scene file needs 'scenes'");
    }
    YamlNode root = node(next(), 0);
    next();
    Event after = next();
    if (after.getEventId() == Event.ID.DocumentStart) {
      throw new Unreadable(
          place(after), "a second YAML document begins here: a scene file is one document");
    }
    return root;
  }

  private YamlNode node(Event event, int depth) {
    if (event instanceof AliasEvent alias) {
      return named(alias);
    }
    count(1, event);
    NodeEvent begin = (NodeEvent) event;
    String anchor = begin.getAnchor().map(a -> a.getValue()).orElse(null);
    if (begin instanceof ScalarEvent scalar) {
      refuseTag(scalar.getTag().orElse(null), scalar);
      Scalar node = new Scalar(place(scalar), scalar.getValue(), scalar.isPlain());
      remember(anchor, node, 1);
      return node;
    }
    refuseTag(((CollectionStartEvent) begin).getTag().orElse(null), begin);
    if (depth == DEEPEST) {
      throw new Unreadable(
          place(begin), "lists and maps are nested more than " + DEEPEST + " deep");
    }
    long before = size - 1;
    remember(anchor, null, 0);
    YamlNode node =
        begin.getEventId() == Event.ID.SequenceStart
            ? sequence(place(begin), depth + 1)
            : mapping(place(begin), depth + 1);
    remember(anchor, node, size - before);
    return node;
  }

  private Sequence sequence(Place place, int depth) {
    List<YamlNode> items = new ArrayList<>();
    Event event = next();
    while (event.getEventId() != Event.ID.SequenceEnd) {
      items.add(node(event, depth));
      event = next();
    }
    return new Sequence(place, items);
  }

  private Mapping mapping(Place place, int depth) {
    List<Entry> entries = new ArrayList<>();
    Event event = next();
    while (event.getEventId() != Event.ID.MappingEnd) {
      YamlNode key = node(event, depth);
      entries.add(new Entry(key, node(next(), depth)));
      event = next();
    }
    return new Mapping(place, entries);
  }

  private YamlNode named(AliasEvent alias) {
    String name = alias.getAlias().getValue();
    Anchored target = anchors.get(name);
    String shown = SourceText.quote("*" + name);
    if (target == null) {
      throw new Unreadable(
          place(alias),
          "alias " + shown + " has no anchor before it" + Suggestion.hint(name, anchors.keySet()));
    }
    if (target.node == null) {
      throw new Unreadable(
          place(alias), "alias " + shown + " stands within what it names and would never end");
    }
    count(target.size, alias);
    return target.node;
  }

  private void remember(String anchor, YamlNode node, long nodeSize) {
    if (anchor != null) {
      anchors.put(anchor, new Anchored(node, nodeSize));
    }
  }

  private void count(long more, Event event) {
    size += more;
    if (size > MOST_NODES) {
      throw new Unreadable(
          place(event),
          "too large: more than " + MOST_NODES + " values up to here, aliases written out");
    }
  }

  private static void refuseTag(String tag, Event event) {
    if (tag != null) {
      throw new Unreadable(
          place(event), "tags such as " + SourceText.quote(tag) + " have no use in scene files");
    }
  }

  private Event next() {
    Event event = events.next();
    reached = place(event);
    return event;
  }

  private static Place place(Event event) {
    return YamlErrors.place(event.getStartMark());
  }

  /** Ends the reading of a file that is no YAML document of use. */
  private static final class Unreadable extends RuntimeException {

    private static final long serialVersionUID = 1;

    private final transient Place place;

    Unreadable(Place place, String message) {
      super(message);
      this.place = place;
    }
  }
}

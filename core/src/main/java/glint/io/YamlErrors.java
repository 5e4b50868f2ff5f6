package glint.io;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;

/** Puts the errors of the YAML engine into words for people who write scenes. */
final class YamlErrors {

  /** What the engine says, and what we say instead; $1 is the part in brackets. */
  private static final Map<Pattern, String> WORDS = new LinkedHashMap<>();

  static {
    say("found character '(?:\\\\t\\(TAB\\)| )'.*", "a tab cannot stand here; use spaces");
    say("found character '(.+)' that.*", "text that begins with '$1' needs quotes");
    say("found unexpected end of stream", "these quotes are never closed");
    say(
        "mapping values are not allowed here",
        "a ':' cannot stand here: check the indentation, or put text that holds ': ' in quotes");
    say("mapping keys are not allowed here", "a '?' cannot stand here");
    say("sequence entries are not allowed here", "a '-' cannot stand here: begin a new line");
    say("could not find expected ':'", "a ':' is missing after the key");
    say("expected <block end>, but found '([\\]}])'", "this '$1' closes nothing");
    say("expected <block end>.*", "this does not fit the lines above: check the indentation");
    say("expected (',' or '.') ?, but got.*", "$1 is missing before this");
    say(
        "expected '<document start>'.*",
        "this does not fit the lines above: check the indentation");
    say("unexpected character found.*", "text that begins with '&' or '*' needs quotes");
    say(
        "expected (?:a comment or a line break|chomping).*",
        "text after '|' or '>' begins on the next line");
    say("expected the node content, but found '(.+)'", "a value is missing before '$1'");
  }

  private YamlErrors() {}

  static void report(MarkedYamlEngineException e, Problems problems) {
    String said = String.valueOf(e.getProblem());
    boolean unclosed = said.startsWith("found unexpected end of stream");
    Place place = place(unclosed ? e.getContextMark() : e.getProblemMark());
    boolean flow = String.valueOf(e.getContext()).contains("flow") && said.startsWith("expected '");
    for (Map.Entry<Pattern, String> each : WORDS.entrySet()) {
      Matcher matcher = each.getKey().matcher(said);
      if (matcher.matches()) {
        String where = flow ? "; its bracket was opened at " + place(e.getContextMark()) : "";
        problems.report(place, matcher.replaceFirst(each.getValue()) + where);
        return;
      }
    }
    problems.report(place, "is not YAML: " + said.replaceAll("\\s+", " "));
  }

  static Place place(Optional<Mark> mark) {
    return mark.map(m -> new Place(m.getLine() + 1, m.getColumn() + 1)).orElse(Place.NONE);
  }

  private static void say(String engine, String ours) {
    WORDS.put(Pattern.compile(engine, Pattern.DOTALL), ours);
  }
}

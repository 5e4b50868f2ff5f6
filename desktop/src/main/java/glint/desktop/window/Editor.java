package glint.desktop.window;

import java.awt.Desktop;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Opens places of text files in the user's editor; not for the event thread. */
final class Editor {

  /** How editors with a window of their own are told of file {0}, line {1} and column {2}. */
  private static final Map<String, String> KNOWN =
      Map.ofEntries(
          Map.entry("code", "--goto {0}:{1}:{2}"),
          Map.entry("codium", "--goto {0}:{1}:{2}"),
          Map.entry("subl", "{0}:{1}:{2}"),
          Map.entry("zed", "{0}:{1}:{2}"),
          Map.entry("gedit", "{0} +{1}:{2}"),
          Map.entry("gnome-text-editor", "{0} +{1}:{2}"),
          Map.entry("kate", "--line {1} --column {2} {0}"),
          Map.entry("kwrite", "--line {1} --column {2} {0}"),
          Map.entry("gvim", "+{1} {0}"),
          Map.entry("mvim", "+{1} {0}"),
          Map.entry("emacs", "+{1}:{2} {0}"),
          Map.entry("idea", "--line {1} --column {2} {0}"),
          Map.entry("mate", "--line {1}:{2} {0}"),
          Map.entry("notepad++", "-n{1} -c{2} {0}"));

  /** Arguments that would have an editor keep a terminal waiting. */
  private static final Set<String> WAITING = Set.of("--wait", "-w", "-f", "--nofork");

  private final Map<String, String> environment;

  /**
   * Makes an editor.
   *
   * @param environment its VISUAL or else EDITOR is used if it is known to have a window
   */
  Editor(Map<String, String> environment) {
    this.environment = environment;
  }

  /**
   * Opens a place, or where no editor is known to take one, its file.
   *
   * @throws IOException if that cannot be; its message says why in words for people
   */
  void open(Place place) throws IOException {
    Optional<List<String>> command = command(place);
    if (command.isPresent()) {
      var unused =
          new ProcessBuilder(command.get())
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      return;
    }
    Desktop desktop = Desktop.isDesktopSupported() ? Desktop.getDesktop() : null;
    if (desktop != null && desktop.isSupported(Desktop.Action.EDIT)) {
      desktop.edit(place.file().toFile());
    } else if (desktop != null && desktop.isSupported(Desktop.Action.OPEN)) {
      desktop.open(place.file().toFile());
    } else {
      throw new IOException("VISUAL names no editor with a window");
    }
  }

  /** Returns the command that opens a place; nothing if no known editor is named. */
  Optional<List<String>> command(Place place) {
    for (String variable : List.of("VISUAL", "EDITOR")) {
      List<String> words =
          new ArrayList<>(List.of(environment.getOrDefault(variable, "").trim().split("\\s+")));
      words.removeIf(WAITING::contains);
      String arguments = words.isEmpty() ? null : KNOWN.get(name(words.get(0)));
      if (arguments != null) {
        for (String argument : arguments.split(" ")) {
          words.add(
              argument
                  .replace("{1}", String.valueOf(place.line()))
                  .replace("{2}", String.valueOf(place.column()))
                  .replace("{0}", place.file().toAbsolutePath().toString()));
        }
        return Optional.of(words);
      }
    }
    return Optional.empty();
  }

  private static String name(String program) {
    String name =
        program.substring(Math.max(program.lastIndexOf('/'), program.lastIndexOf('\\')) + 1);
    return name.toLowerCase(Locale.ROOT).replaceFirst("\\.(exe|cmd)$", "");
  }
}

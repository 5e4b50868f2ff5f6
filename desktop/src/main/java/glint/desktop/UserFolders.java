package glint.desktop;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/**
 * Where this system wants programs to keep what is theirs; immutable.
 *
 * @param state for what is remembered
 * @param cache for what can be made again
 */
record UserFolders(Path state, Path cache) {

  /** Returns those of this user. */
  static UserFolders here() {
    Path home = Path.of(System.getProperty("user.home"));
    return of(System.getenv(), System.getProperty("os.name"), home);
  }

  /** Returns those of a user of some system: XDG's on Linux and the like. */
  static UserFolders of(Map<String, String> environment, String system, Path home) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.startsWith("windows")) {
      Path local = folder(environment, "LOCALAPPDATA", home.resolve("AppData").resolve("Local"));
      return new UserFolders(local.resolve("Glint"), local.resolve("Glint").resolve("cache"));
    } else if (name.startsWith("mac")) {
      Path library = home.resolve("Library");
      return new UserFolders(
          library.resolve("Application Support").resolve("Glint"),
          library.resolve("Caches").resolve("Glint"));
    }
    Path state = folder(environment, "XDG_STATE_HOME", home.resolve(".local").resolve("state"));
    Path cache = folder(environment, "XDG_CACHE_HOME", home.resolve(".cache"));
    return new UserFolders(state.resolve("glint"), cache.resolve("glint"));
  }

  private static Path folder(Map<String, String> environment, String variable, Path otherwise) {
    Path named = Path.of(environment.getOrDefault(variable, ""));
    return named.isAbsolute() ? named : otherwise;
  }
}

package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Checks where a user's things are kept. */
class UserFoldersTest {

  private static final Path HOME = Path.of("/home/ann").toAbsolutePath();

  @Test
  void everySystemHasItsFolders() {
    assertEquals(
        new UserFolders(HOME.resolve(".local/state/glint"), HOME.resolve(".cache/glint")),
        UserFolders.of(Map.of("XDG_CACHE_HOME", "relative"), "Linux", HOME));
    Path state = HOME.resolve("s");
    assertEquals(
        new UserFolders(state.resolve("glint"), HOME.resolve("c/glint")),
        UserFolders.of(
            Map.of("XDG_STATE_HOME", state.toString(), "XDG_CACHE_HOME", HOME + "/c"),
            "FreeBSD",
            HOME));
    assertEquals(
        new UserFolders(
            HOME.resolve("Library/Application Support/Glint"),
            HOME.resolve("Library/Caches/Glint")),
        UserFolders.of(Map.of(), "Mac OS X", HOME));
    assertEquals(
        new UserFolders(
            HOME.resolve("AppData/Local/Glint"), HOME.resolve("AppData/Local/Glint/cache")),
        UserFolders.of(Map.of(), "Windows 11", HOME));
  }
}

package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {

  @TempDir private Path dir;

  @Test
  void theTargetAppearsWholeOrNotAtAll() throws IOException {
    Path target = dir.resolve("image.png");
    AtomicFile.write(
        target,
        path -> {
          Files.writeString(path, "half");
          assertEquals(1, Run.list(dir).size());
          assertTrue(Run.list(dir).get(0).matches("\\.image\\.png\\..*\\.tmp"), "" + Run.list(dir));
          Files.writeString(path, "whole");
        });
    assertEquals("whole", Files.readString(target));
    assertEquals(List.of("image.png"), Run.list(dir));
  }

  @Test
  void aFailureLeavesWhatWasThere() throws IOException {
    Path target = Files.writeString(dir.resolve("image.png"), "old");
    IOException failure =
        assertThrows(
            IOException.class,
            () ->
                AtomicFile.write(
                    target,
                    path -> {
                      Files.writeString(path, "half");
                      throw new IOException("the disk is full");
                    }));
    assertEquals("the disk is full", failure.getMessage());
    assertEquals("old", Files.readString(target));
    assertEquals(List.of("image.png"), Run.list(dir));
  }

  @Test
  void aLinkIsFollowedAndStays() throws IOException {
    Path file = Files.writeString(dir.resolve("elsewhere"), "old");
    Path link = Files.createSymbolicLink(dir.resolve("link"), file);
    AtomicFile.write(link, path -> Files.writeString(path, "new"));
    assertTrue(Files.isSymbolicLink(link));
    assertEquals("new", Files.readString(file));
  }

  @Test
  void whatIsUnfinishedCanBeSweptAway() throws IOException {
    Path target = dir.resolve("image.png");
    assertThrows(
        IOException.class,
        () ->
            AtomicFile.write(
                target,
                path -> {
                  Files.writeString(path, "half");
                  AtomicFile.deleteUnfinished();
                }));
    assertEquals(List.of(), Run.list(dir));
  }
}

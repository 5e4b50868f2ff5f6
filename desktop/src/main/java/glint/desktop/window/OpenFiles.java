package glint.desktop.window;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;

/** The files that are open: reads them, again whenever they change, and fills the lists. */
final class OpenFiles {

  private final Library library = new Library();
  private final SceneSource source;
  private final SceneList list;
  private final Problems problems;
  private final Workers workers;
  private final Thumbnails thumbnails;
  private final FileWatch watch = new FileWatch(this::readAgain);

  /** Sets up no file. */
  OpenFiles(
      SceneSource source,
      SceneList list,
      Problems problems,
      Workers workers,
      Thumbnails thumbnails) {
    this.thumbnails = thumbnails;
    this.source = source;
    this.list = list;
    this.problems = problems;
    this.workers = workers;
    watch.start(workers);
  }

  /** Reads files in the background; the first scene of the first that has one is chosen. */
  void open(List<Path> files) {
    boolean[] chosen = new boolean[1];
    for (Path file : files) {
      workers.disk(
          () -> {
            SceneSource.Found found = source.read(file);
            SwingUtilities.invokeLater(
                () -> {
                  boolean choose = !chosen[0] && !found.scenes().isEmpty();
                  chosen[0] |= choose;
                  show(file, found, choose ? Optional.of(found.scenes().get(0)) : Optional.empty());
                });
          });
    }
  }

  private void readAgain(Path file) {
    workers.disk(
        () -> {
          SceneSource.Found found = source.read(file);
          SwingUtilities.invokeLater(() -> show(file, found, Optional.empty()));
        });
  }

  private void show(Path file, SceneSource.Found found, Optional<Picked> choose) {
    library.put(file, found);
    watch.watch(file, found.parts());
    problems.show(library.problems());
    list.show(library.scenes(), choose);
    thumbnails.want(library.scenes());
  }
}

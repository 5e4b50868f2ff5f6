package glint.desktop;

import glint.desktop.window.Desk;
import glint.desktop.window.GlintWindow;
import glint.desktop.window.Picked;
import glint.desktop.window.SceneSource;
import java.awt.GraphicsEnvironment;
import java.io.PrintWriter;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint window}: scenes to pick from, and their pictures as they are rendered. */
@Command(
    name = "window",
    description = "Opens a window with the scenes of each file to pick from.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: glint window scenes/stories.yaml"})
final class WindowCommand implements Callable<Integer> {

  private static final String NO_DISPLAY =
      "there is no display to open a window on; 'glint render FILE' renders without one";

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "FILE",
      arity = "0..*",
      description = "Scene files or models (default: the bundled gallery).")
  private List<Path> files = new ArrayList<>();

  @Override
  public Integer call() throws RunException, InterruptedException {
    return open(files, spec.commandLine().getErr());
  }

  /** Opens a window with the scenes of files, or of the gallery if none is named, until closed. */
  static int open(List<Path> files, PrintWriter err) throws RunException, InterruptedException {
    if (GraphicsEnvironment.isHeadless()) {
      throw new RunException(NO_DISPLAY);
    }
    List<Path> named = files.isEmpty() ? List.of(gallery()) : files;
    GlintWindow.open(named, desk(err)).awaitClosed();
    return ExitCode.DONE;
  }

  private static Desk desk(PrintWriter err) {
    UserFolders folders = UserFolders.here();
    return new Desk(
        file -> read(file, err),
        new WindowImages(),
        folders.state().resolve("window.properties"),
        folders.cache().resolve("thumbnails-" + Version.glint()),
        System.getenv());
  }

  /** Reads a file for the window. */
  static SceneSource.Found read(Path file, PrintWriter err) {
    Inputs inputs = Inputs.read(List.of(file), err);
    return new SceneSource.Found(
        inputs.jobs().stream()
            .map(job -> new Picked(job.file(), job.digest(), job.scene()))
            .toList(),
        inputs.problems().stream().map(Failed::message).toList(),
        inputs.parts());
  }

  /** Returns the gallery: in the folder scenes/ beside the lib/ that this program runs from. */
  private static Path gallery() throws RunException {
    Path gallery;
    try {
      Path jar =
          Path.of(WindowCommand.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      gallery = jar.resolveSibling("../scenes/gallery.yaml").normalize();
    } catch (URISyntaxException e) {
      throw new RunException("cannot tell where Glint is installed", e);
    }
    if (!Files.exists(gallery)) {
      throw new RunException("the gallery is not in " + gallery + "; name a scene file");
    }
    return gallery;
  }
}

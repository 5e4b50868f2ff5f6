package glint.desktop.window;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for files; begins in the folder where the last one was found. */
final class FileDialogs {

  private final Component parent;
  private File scenes = new File("").getAbsoluteFile();
  private File images = scenes;

  /** Sets up dialogs over a window. */
  FileDialogs(Component parent) {
    this.parent = parent;
  }

  /** Returns the scene files that are chosen; none if the dialog is dismissed. */
  List<Path> openScenes() {
    JFileChooser chooser = new JFileChooser(scenes);
    chooser.setMultiSelectionEnabled(true);
    chooser.setFileFilter(filter("Scenes and models", "yaml", "yml", "txt", "nff", "obj"));
    boolean chosen = chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION;
    scenes = chooser.getCurrentDirectory();
    return chosen
        ? Arrays.stream(chooser.getSelectedFiles()).map(File::toPath).toList()
        : List.of();
  }

  /** Returns the image that is chosen to be read. */
  Optional<Path> openImage() {
    JFileChooser chooser = new JFileChooser(images);
    chooser.setDialogTitle("Compare with");
    chooser.setFileFilter(filter("Images", "png", "pfm"));
    boolean chosen = chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION;
    images = chooser.getCurrentDirectory();
    return chosen ? Optional.of(chooser.getSelectedFile().toPath()) : Optional.empty();
  }

  /**
   * Returns where an image shall be written, with an ending; a file that is there is asked about.
   */
  Optional<Path> saveImage(String name) {
    JFileChooser chooser = new JFileChooser(images);
    chooser.setDialogTitle("Save image");
    FileNameExtensionFilter png = filter("PNG, as displayed", "png");
    FileNameExtensionFilter pfm = filter("PFM, linear light in 32-bit floats", "pfm");
    chooser.setAcceptAllFileFilterUsed(false);
    chooser.addChoosableFileFilter(png);
    chooser.addChoosableFileFilter(pfm);
    chooser.setFileFilter(png);
    chooser.setSelectedFile(new File(images, name + ".png"));
    boolean chosen = chooser.showSaveDialog(parent) == JFileChooser.APPROVE_OPTION;
    images = chooser.getCurrentDirectory();
    if (!chosen) {
      return Optional.empty();
    }
    Path file = withEnding(chooser.getSelectedFile(), chooser.getFileFilter() == pfm);
    return !file.toFile().exists() || mayReplace(file) ? Optional.of(file) : Optional.empty();
  }

  private boolean mayReplace(Path file) {
    String question = file.getFileName() + " is there already. Replace it?";
    return JOptionPane.showConfirmDialog(parent, question, "Save image", JOptionPane.YES_NO_OPTION)
        == JOptionPane.YES_OPTION;
  }

  private static Path withEnding(File file, boolean pfm) {
    String name = file.getName().toLowerCase(Locale.ROOT);
    boolean kept = name.endsWith(".pfm") || (name.endsWith(".png") && !pfm);
    if (kept) {
      return file.toPath();
    }
    String stem = name.endsWith(".png") ? file.getPath().replaceFirst("....$", "") : file.getPath();
    return Path.of(stem + (pfm ? ".pfm" : ".png"));
  }

  private static FileNameExtensionFilter filter(String words, String... endings) {
    return new FileNameExtensionFilter(words, endings);
  }
}

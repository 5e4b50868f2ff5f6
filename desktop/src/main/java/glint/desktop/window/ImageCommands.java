package glint.desktop.window;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.ButtonGroup;

/** What menus and keys do with the image of a render. */
final class ImageCommands {

  private final Viewing viewing;
  private final ImageWork work;
  private final FileDialogs dialogs;
  private final Supplier<BufferedImage> shown;

  /**
   * Makes the commands.
   *
   * @param shown returns the picture that is seen, or null
   */
  ImageCommands(
      Viewing viewing, ImageWork work, FileDialogs dialogs, Supplier<BufferedImage> shown) {
    this.viewing = viewing;
    this.work = work;
    this.dialogs = dialogs;
    this.shown = shown;
  }

  /** Adds those that belong to files to the present menu. */
  void addFiles(Controls controls) {
    controls.add("Save image", "menu S", this::save);
    controls.item("Copy picture", "menu C", this::copy);
    controls.item("Compare with", "menu D", () -> compare(() -> {}));
  }

  /** Adds those that choose what is seen to the present menu. */
  void addLooks(Controls controls) {
    ButtonGroup looks = new ButtonGroup();
    controls.choice(looks, "Picture", "P", () -> viewing.show(Look.PICTURE));
    controls.choice(looks, "Error", "E", () -> viewing.show(Look.ERROR));
    controls.choice(looks, "Samples", "N", () -> viewing.show(Look.SAMPLES));
    controls.choice(looks, "Split", "B", () -> look(Look.SPLIT));
    controls.choice(looks, "Difference", "X", () -> look(Look.DIFFERENCE));
  }

  private void save() {
    Optional<Picked> picked = viewing.picked();
    Optional<Snapshot> snapshot = viewing.snapshot().filter(s -> s.linear().isPresent());
    if (picked.isPresent() && snapshot.isPresent()) {
      Optional<Path> file = dialogs.saveImage(picked.get().scene().name());
      file.ifPresent(to -> work.save(picked.get(), snapshot.get(), to));
    }
  }

  private void copy() {
    if (shown.get() != null) {
      work.copy(shown.get());
    }
  }

  /** Asks for an image to compare with, and does something once it is there. */
  private void compare(Runnable then) {
    Optional<Picked> picked = viewing.picked();
    if (picked.isPresent()) {
      Consumer<Comparand> receiver =
          read -> {
            viewing.compare(read);
            then.run();
          };
      dialogs
          .openImage()
          .ifPresent(file -> work.load(file, picked.get().scene().transfer(), receiver));
    }
  }

  private void look(Look look) {
    viewing.show(look);
    if (viewing.other().isEmpty()) {
      compare(() -> viewing.show(look));
    }
  }
}

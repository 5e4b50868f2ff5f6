package glint.desktop.window;

import static glint.desktop.window.Snapshot.State.DONE;

import glint.color.Transfer;
import glint.image.Image;
import glint.render.Statistics;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Saves and copies images, and loads those to compare with. */
final class ImageWork {

  private final ImageStore store;
  private final Workers workers;
  private final Notice notice;

  /** Sets up work that tells how it went. */
  ImageWork(ImageStore store, Workers workers, Notice notice) {
    this.store = store;
    this.workers = workers;
    this.notice = notice;
  }

  /** Writes what there is of a scene's image. */
  void save(Picked picked, Snapshot snapshot, Path file) {
    Image image = snapshot.linear().get();
    Optional<Statistics> statistics =
        snapshot
            .findings()
            .filter(findings -> findings.prepared().scene().equals(picked.scene()))
            .flatMap(Findings::statistics);
    workers.disk(
        () -> {
          try {
            store.write(picked, image, statistics, file);
            say("saved " + file + (snapshot.state() == DONE ? "" : ", as far as it is rendered"));
          } catch (IOException | RuntimeException e) {
            say("cannot save: " + e.getMessage());
          }
        });
  }

  /** Puts a picture on the clipboard. */
  void copy(BufferedImage picture) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new Copied(picture), null);
    notice.say("copied " + picture.getWidth() + "x" + picture.getHeight() + " pixels");
  }

  /** Reads an image to compare with. */
  void load(Path file, Transfer transfer, Consumer<Comparand> receiver) {
    workers.disk(
        () -> {
          try {
            Comparand read = Comparand.of(file, store.read(file, transfer), transfer);
            SwingUtilities.invokeLater(() -> receiver.accept(read));
          } catch (IOException | RuntimeException e) {
            say("cannot compare: " + e.getMessage());
          }
        });
  }

  private void say(String words) {
    SwingUtilities.invokeLater(() -> notice.say(words));
  }

  private record Copied(BufferedImage picture) implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {DataFlavor.imageFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
      return DataFlavor.imageFlavor.equals(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
      if (!isDataFlavorSupported(flavor)) {
        throw new UnsupportedFlavorException(flavor);
      }
      return picture;
    }
  }
}

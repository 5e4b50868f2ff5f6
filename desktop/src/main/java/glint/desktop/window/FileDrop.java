package glint.desktop.window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Takes files that are dropped or pasted. */
final class FileDrop extends TransferHandler {

  private static final long serialVersionUID = 1;

  private final transient Consumer<List<Path>> receiver;

  /**
   * Makes a place for files.
   *
   * @param receiver hears of the files
   */
  FileDrop(Consumer<List<Path>> receiver) {
    this.receiver = receiver;
  }

  @Override
  public boolean canImport(TransferSupport offer) {
    return offer.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
  }

  @Override
  public boolean importData(TransferSupport offer) {
    List<Path> files = new ArrayList<>();
    try {
      Object offered = offer.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
      for (Object file : (List<?>) offered) {
        files.add(((File) file).toPath());
      }
    } catch (UnsupportedFlavorException | IOException e) {
      return false; // another program has taken its offer back
    }
    receiver.accept(files);
    return true;
  }
}

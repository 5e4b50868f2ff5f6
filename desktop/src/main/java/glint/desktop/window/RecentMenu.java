package glint.desktop.window;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** The files that were opened last, to open again. */
final class RecentMenu extends JMenu implements MenuListener {

  private static final long serialVersionUID = 1;

  private final transient Supplier<List<Path>> files;
  private final transient Consumer<List<Path>> opener;

  /** Makes a menu that is filled whenever it opens. */
  RecentMenu(Supplier<List<Path>> files, Consumer<List<Path>> opener) {
    super("Open recent");
    this.files = files;
    this.opener = opener;
    addMenuListener(this);
  }

  @Override
  public void menuSelected(MenuEvent e) {
    removeAll();
    for (Path file : files.get()) {
      JMenuItem item = new JMenuItem(file.getFileName() + "  (" + file.getParent() + ")");
      item.addActionListener(chosen -> opener.accept(List.of(file)));
      add(item);
    }
    if (getItemCount() == 0) {
      add(new JMenuItem("None yet")).setEnabled(false);
    }
  }

  @Override
  public void menuDeselected(MenuEvent e) {}

  @Override
  public void menuCanceled(MenuEvent e) {}
}

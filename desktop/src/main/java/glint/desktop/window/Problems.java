package glint.desktop.window;

import java.awt.Dimension;
import java.util.List;
import javax.swing.JList;
import javax.swing.JScrollPane;

/** What is wrong with files, a line each; takes no place while there is nothing. */
final class Problems extends JScrollPane {

  private static final long serialVersionUID = 1;

  private final JList<String> list = new JList<>();

  /** Makes an empty panel. */
  Problems() {
    list.setName("problems");
    list.getAccessibleContext().setAccessibleName("Problems");
    setViewportView(list);
    setPreferredSize(new Dimension(0, 80));
    setVisible(false);
  }

  /** Shows lines instead of those before. */
  void show(List<String> lines) {
    list.setListData(lines.toArray(new String[0]));
    setVisible(!lines.isEmpty());
    getParent().revalidate();
  }
}

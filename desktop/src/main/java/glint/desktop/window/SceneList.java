package glint.desktop.window;

import java.awt.Component;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.text.Position;

/** The scenes to choose from. */
final class SceneList extends JList<Picked> {

  private static final long serialVersionUID = 1;

  /**
   * Makes an empty list.
   *
   * @param chosen hears of the scene that is chosen
   */
  SceneList(Consumer<Picked> chosen) {
    setName("scenes");
    getAccessibleContext().setAccessibleName("Scenes");
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setCellRenderer(new Cell());
    getInputMap().put(KeyStroke.getKeyStroke("SPACE"), "none"); // it pauses, anywhere in the window
    addListSelectionListener(
        e -> {
          if (!e.getValueIsAdjusting() && getSelectedValue() != null) {
            chosen.accept(getSelectedValue());
          }
        });
  }

  /** Finds nothing: letters that are typed are keys of the window. */
  @Override
  public int getNextMatch(String prefix, int startIndex, Position.Bias bias) {
    return -1;
  }

  /** Shows more scenes, in place of those of the same files, and chooses the first of them. */
  void add(List<Picked> more) {
    List<Path> files = more.stream().map(Picked::file).toList();
    List<Picked> all = new ArrayList<>();
    for (int i = 0; i < getModel().getSize(); i++) {
      if (!files.contains(getModel().getElementAt(i).file())) {
        all.add(getModel().getElementAt(i));
      }
    }
    int first = all.size();
    all.addAll(more);
    if (!more.isEmpty()) {
      setListData(all.toArray(new Picked[0]));
      setSelectedIndex(first);
      ensureIndexIsVisible(all.size() - 1);
      ensureIndexIsVisible(first);
    }
  }

  private static final class Cell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      Picked picked = (Picked) value;
      JLabel label =
          (JLabel) super.getListCellRendererComponent(list, value, index, selected, focused);
      label.setText(picked.scene().name());
      label.setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
      label.setToolTipText(picked.scene().title().isEmpty() ? null : picked.scene().title());
      return label;
    }
  }
}

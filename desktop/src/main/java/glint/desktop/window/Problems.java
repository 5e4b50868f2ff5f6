package glint.desktop.window;

import java.awt.Color;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import javax.swing.text.Position;

/** What is wrong with files, a line each; takes no place while there is nothing. */
final class Problems extends JScrollPane {

  private static final long serialVersionUID = 1;

  private static final int MOST_ROWS = 6;

  private final transient Consumer<Place> opener;
  private final JList<String> list = new Lines();

  /**
   * Makes an empty panel.
   *
   * @param opener hears of places that are clicked on
   */
  Problems(Consumer<Place> opener) {
    this.opener = opener;
    list.setName("problems");
    list.getAccessibleContext().setAccessibleName("Problems");
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setCellRenderer(new Cell());
    list.setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent e) {
            int index = list.locationToIndex(e.getPoint());
            if (index >= 0 && list.getCellBounds(index, index).contains(e.getPoint())) {
              open(index);
            }
          }
        });
    list.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "open");
    list.getActionMap()
        .put(
            "open",
            new AbstractAction() {
              private static final long serialVersionUID = 1;

              @Override
              public void actionPerformed(ActionEvent e) {
                open(list.getSelectedIndex());
              }
            });
    setViewportView(list);
    setVisible(false);
  }

  /** Shows lines instead of those before. */
  void show(List<String> lines) {
    list.setListData(lines.toArray(new String[0]));
    list.setVisibleRowCount(Math.min(MOST_ROWS, lines.size()));
    setVisible(!lines.isEmpty());
    getParent().revalidate();
  }

  /** Chooses the next problem and opens its place. */
  void openNext() {
    int count = list.getModel().getSize();
    if (count > 0) {
      int next = (list.getSelectedIndex() + 1) % count;
      list.setSelectedIndex(next);
      list.ensureIndexIsVisible(next);
      open(next);
    }
  }

  private void open(int index) {
    if (index >= 0) {
      Place.of(list.getModel().getElementAt(index)).ifPresent(opener);
    }
  }

  /** A list in which nothing is searched by typing: letters are keys of the window. */
  private static final class Lines extends JList<String> {
    private static final long serialVersionUID = 1;

    @Override
    public int getNextMatch(String prefix, int startIndex, Position.Bias bias) {
      return -1;
    }
  }

  private static final class Cell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      super.getListCellRendererComponent(list, value, index, selected, focused);
      String line = (String) value;
      Optional<Place> place = Place.of(line);
      setBorder(BorderFactory.createEmptyBorder(2, 10, 2, 10));
      setToolTipText(line);
      if (place.isPresent() && !selected) {
        setText(linked(line, place.get().toString().length()));
      }
      return this;
    }

    private static String linked(String line, int end) {
      Color link = UIManager.getColor("Component.linkColor");
      String colour = String.format(Locale.ROOT, "#%06x", link.getRGB() & 0xffffff);
      return "<html><nobr><font color="
          + colour
          + ">"
          + Html.escaped(line.substring(0, end))
          + "</font>"
          + Html.escaped(line.substring(end))
          + "</nobr>";
    }
  }
}

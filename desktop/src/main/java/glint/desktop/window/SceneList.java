package glint.desktop.window;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import javax.swing.text.Position;

/** The scenes to choose from. */
final class SceneList extends JList<Picked> {

  private static final long serialVersionUID = 1;

  private boolean silent;

  /**
   * Makes an empty list.
   *
   * @param chosen hears of the scene that is chosen
   * @param thumbnails returns small pictures, as far as there are any
   */
  SceneList(Consumer<Picked> chosen, Function<Picked, Optional<BufferedImage>> thumbnails) {
    setName("scenes");
    getAccessibleContext().setAccessibleName("Scenes");
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setCellRenderer(new Cell(thumbnails));
    for (String key : List.of("SPACE", "menu C")) { // they are of the whole window
      getInputMap().put(Keys.of(key).get(0), "none");
    }
    addListSelectionListener(
        e -> {
          if (!silent && !e.getValueIsAdjusting() && getSelectedValue() != null) {
            chosen.accept(getSelectedValue());
          }
        });
  }

  /** Keeps to the width that there is: a name that is longer ends in dots. */
  @Override
  public boolean getScrollableTracksViewportWidth() {
    return true;
  }

  /** Finds nothing: letters that are typed are keys of the window. */
  @Override
  public int getNextMatch(String prefix, int startIndex, Position.Bias bias) {
    return -1;
  }

  /**
   * Shows scenes instead of those before. Without a choice the same scene stays chosen, and is only
   * heard of again if it has changed; if it is gone, none is chosen.
   */
  void show(List<Picked> scenes, Optional<Picked> choice) {
    Picked before = getSelectedValue();
    Optional<Picked> next =
        choice.isPresent() || before == null
            ? choice
            : scenes.stream().filter(before::isVersionOf).findFirst();
    boolean same = before != null && next.isPresent() && choice.isEmpty();
    silent = same && before.digest().equals(next.get().digest());
    setListData(scenes.toArray(new Picked[0]));
    next.ifPresent(picked -> setSelectedIndex(scenes.indexOf(picked)));
    silent = false;
    if (choice.isPresent()) {
      ensureIndexIsVisible(scenes.size() - 1);
    }
    ensureIndexIsVisible(getSelectedIndex());
  }

  private static final class Cell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1;

    private final transient Function<Picked, Optional<BufferedImage>> thumbnails;

    Cell(Function<Picked, Optional<BufferedImage>> thumbnails) {
      this.thumbnails = thumbnails;
    }

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      Picked picked = (Picked) value;
      String name = picked.scene().name();
      JLabel label =
          (JLabel) super.getListCellRendererComponent(list, name, index, selected, focused);
      label.setIcon(new ThumbnailIcon(thumbnails.apply(picked)));
      label.setIconTextGap(10);
      label.setBorder(BorderFactory.createEmptyBorder(3, 6, 3, 6));
      label.setToolTipText(picked.scene().title().isEmpty() ? null : picked.scene().title());
      return label;
    }
  }
}

package glint.desktop.window;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;

/** A sheet with everything that keys and the mouse do; not modal. */
final class Shortcuts extends JDialog {

  private static final long serialVersionUID = 1;

  private static final int COLUMNS = 3;

  /** What no menu has. */
  private static final List<Controls.Command> MOUSE =
      List.of(
          new Controls.Command("Mouse", "Orbit", "Drag"),
          new Controls.Command("Mouse", "Nearer, farther", "Wheel"),
          new Controls.Command("Mouse", "Set the target", "Double click"),
          new Controls.Command("Mouse", "Open a problem's place", "Click on it"));

  /** Makes a sheet over a window. */
  Shortcuts(JFrame owner, List<Controls.Command> commands) {
    super(owner, "Keys");
    setName("shortcuts");
    Map<String, List<Controls.Command>> groups = new LinkedHashMap<>();
    List<Controls.Command> all = new ArrayList<>(commands);
    all.addAll(MOUSE);
    all.forEach(c -> groups.computeIfAbsent(c.menu(), menu -> new ArrayList<>()).add(c));
    JPanel[] columns = new JPanel[COLUMNS];
    JPanel sheet = new JPanel(new GridLayout(1, COLUMNS, 32, 0));
    sheet.setBorder(BorderFactory.createEmptyBorder(16, 20, 16, 20));
    for (int i = 0; i < COLUMNS; i++) {
      columns[i] = new JPanel(new GridLayout(0, 1, 0, 4));
      JPanel upper = new JPanel(new BorderLayout());
      upper.add(columns[i], BorderLayout.NORTH);
      sheet.add(upper);
    }
    for (Map.Entry<String, List<Controls.Command>> group : groups.entrySet()) {
      JPanel shortest =
          Collections.min(
              List.of(columns), Comparator.comparingInt(column -> column.getComponentCount()));
      add(shortest, group.getKey(), group.getValue());
    }
    add(sheet);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    pack();
    setLocationRelativeTo(owner);
  }

  private static void add(JPanel column, String name, List<Controls.Command> commands) {
    JLabel title = new JLabel(name);
    title.putClientProperty("FlatLaf.styleClass", "h3");
    title.setVerticalAlignment(SwingConstants.BOTTOM);
    column.add(title);
    for (Controls.Command command : commands) {
      JPanel row = new JPanel(new BorderLayout(24, 0));
      row.add(new JLabel(command.text()), BorderLayout.CENTER);
      JLabel key = new JLabel(command.key(), SwingConstants.TRAILING);
      key.setEnabled(false);
      row.add(key, BorderLayout.EAST);
      column.add(row);
    }
  }
}

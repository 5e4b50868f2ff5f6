package glint.desktop.window;

import glint.color.Rgb;
import glint.scene.Prepared;
import glint.trace.RayTree;
import glint.trace.RayTreeText;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;

/** The rays of a pixel as a tree: each with what it meets, and with the rays that came of it. */
final class RayPanel extends JPanel {

  private static final long serialVersionUID = 1;

  /** So many rows of a tree are open at first. */
  private static final int OPEN_ROWS = 40;

  private static final String HINT =
      "<html>Click on the picture to see the rays of a pixel.</html>";

  private final JLabel title = new JLabel(HINT);
  private final JTree tree = new JTree(new DefaultTreeModel(null));

  /** A ray, as a node of the tree says it. */
  private record Node(int ray, String text) {
    @Override
    public String toString() {
      return text;
    }
  }

  /**
   * Makes an empty panel.
   *
   * @param chosen hears the number of the ray that is chosen, 0 for none
   */
  RayPanel(IntConsumer chosen) {
    super(new BorderLayout());
    title.setName("rays of");
    title.setBorder(BorderFactory.createEmptyBorder(8, 10, 8, 10));
    tree.setName("rays");
    tree.getAccessibleContext().setAccessibleName("Rays of the pixel");
    tree.getSelectionModel().setSelectionMode(TreeSelectionModel.SINGLE_TREE_SELECTION);
    tree.setCellRenderer(new Cell());
    tree.setRowHeight(0); // as high as each text
    tree.addTreeSelectionListener(e -> chosen.accept(ray(e.getNewLeadSelectionPath())));
    JScrollPane scroll = new JScrollPane(tree);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll
        .getViewport()
        .addComponentListener(
            new ComponentAdapter() {
              @Override
              public void componentResized(ComponentEvent e) {
                tree.setCellRenderer(new Cell()); // has all texts measured anew
              }
            });
    add(title, BorderLayout.NORTH);
    add(scroll, BorderLayout.CENTER);
  }

  /** Returns the number of the ray that a node is of, or tells of. */
  private static int ray(TreePath path) {
    for (TreePath at = path; at != null; at = at.getParentPath()) {
      Object content = ((DefaultMutableTreeNode) at.getLastPathComponent()).getUserObject();
      if (content instanceof Node node) {
        return node.ray();
      }
    }
    return 0;
  }

  /** Shows nothing. */
  void clear() {
    title.setText(HINT);
    tree.setModel(new DefaultTreeModel(null));
  }

  /** Shows the rays of a pixel. */
  void show(PixelRays rays) {
    RayTree camera = rays.sample().tree();
    Rgb sum = camera.radiance();
    title.setText(
        String.format(
            Locale.ROOT,
            "<html><b>Pixel %d, %d</b>: the ray through its middle brings %.5f %.5f %.5f</html>",
            rays.pixel().x,
            rays.pixel().y,
            sum.r(),
            sum.g(),
            sum.b()));
    tree.setModel(new DefaultTreeModel(root(rays.scene(), camera)));
    for (int row = 0; row < Math.min(OPEN_ROWS, tree.getRowCount()); row++) {
      tree.expandRow(row);
    }
  }

  private static DefaultMutableTreeNode root(Prepared scene, RayTree camera) {
    Map<Integer, DefaultMutableTreeNode> nodes = new HashMap<>();
    for (RayTree ray : camera.rays()) {
      List<String> lines = RayTreeText.ofRay(scene, ray);
      String first = lines.get(0);
      int end = first.indexOf(", ");
      int weight = first.lastIndexOf(", weight");
      String text = first.substring(0, end) + first.substring(weight);
      DefaultMutableTreeNode node = new DefaultMutableTreeNode(new Node(ray.number(), text));
      node.add(new DefaultMutableTreeNode(first.substring(end + 2, weight)));
      for (String line : lines.subList(1, lines.size())) {
        node.add(new DefaultMutableTreeNode(line.trim()));
      }
      nodes.put(ray.number(), node);
      if (ray.parent() > 0) {
        nodes.get(ray.parent()).add(node);
      }
    }
    return nodes.get(1);
  }

  /** Breaks long texts into lines as wide as the panel. */
  private static final class Cell extends DefaultTreeCellRenderer {
    private static final long serialVersionUID = 1;

    private static final int INDENT = 20;
    private static final int LEAST_WIDTH = 150;

    /** A pixel, in pixels of a style sheet: Swing takes those for larger ones. */
    private static final double STYLED = 1 / 1.3;

    Cell() {
      setLeafIcon(null);
      setOpenIcon(null);
      setClosedIcon(null);
    }

    @Override
    public Component getTreeCellRendererComponent(
        JTree tree,
        Object value,
        boolean selected,
        boolean expanded,
        boolean leaf,
        int row,
        boolean focused) {
      super.getTreeCellRendererComponent(tree, value, selected, expanded, leaf, row, focused);
      int level = ((DefaultMutableTreeNode) value).getLevel() + 1;
      int width = Math.max(LEAST_WIDTH, tree.getVisibleRect().width - INDENT * (level + 1));
      if (getPreferredSize().width > width) {
        String style = "<html><body style='width: " + (int) (STYLED * width) + "px'>";
        setText(style + Html.escaped(value.toString()));
      }
      return this;
    }
  }
}

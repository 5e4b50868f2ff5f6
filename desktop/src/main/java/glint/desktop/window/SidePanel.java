package glint.desktop.window;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;

/** What is known of a render, beside its picture. */
final class SidePanel extends JTabbedPane {

  private static final long serialVersionUID = 1;

  private final ErrorChart chart = new ErrorChart();
  private final LeftOut plan = new LeftOut();
  private final SpeedPanel speed;

  /**
   * Makes an empty panel.
   *
   * @param measures hears when speed is measured from now on, or no longer
   */
  SidePanel(Consumer<Boolean> measures) {
    speed = new SpeedPanel(measures);
    setName("side");
    getAccessibleContext().setAccessibleName("About the render");
    setMinimumSize(new Dimension(150, 0));
    setPreferredSize(new Dimension(290, 100));
    JPanel render = new JPanel(new BorderLayout());
    JScrollPane scroll =
        new JScrollPane(
            plan, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    render.add(chart, BorderLayout.NORTH);
    render.add(scroll, BorderLayout.CENTER);
    addTab("Render", render);
    addTab("Speed", speed);
  }

  /** Shows where a render stands. */
  void show(Snapshot s) {
    chart.show(s);
    speed.show(s);
    s.findings().ifPresent(found -> plan.show(found.prepared().plan().decisions()));
  }

  /** Measures speed against error, or ends that. */
  void measure() {
    setSelectedComponent(speed);
    speed.measureOrCancel();
  }

  /** Ends what runs. */
  void end() {
    speed.end();
  }
}

package glint.desktop.window;

import glint.report.Measurement.Cost;
import glint.report.TargetRuns;
import glint.scene.Prepared;
import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JEditorPane;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

/** Speed against error of the scene that is seen, measured when it is asked for. */
final class SpeedPanel extends JPanel {

  private static final long serialVersionUID = 1;

  private static final String HINT = "error against time";

  private final transient Consumer<Boolean> measures;
  private final JButton button = new JButton("Measure");
  private final JLabel state = new JLabel(HINT);
  private final JPanel charts = new JPanel(new BorderLayout());
  private final JEditorPane words = new JEditorPane("text/html", "");
  private transient Prepared prepared;
  private transient SpeedRun run;

  /**
   * Makes a panel that has measured nothing.
   *
   * @param measures hears when it measures from now on, or no longer
   */
  SpeedPanel(Consumer<Boolean> measures) {
    super(new BorderLayout());
    this.measures = measures;
    button.setName("measure");
    button.setEnabled(false);
    button.addActionListener(e -> measureOrCancel());
    state.setName("measuring");
    words.setName("measured");
    words.getAccessibleContext().setAccessibleName("What was measured");
    words.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    words.setEditable(false);
    words.setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
    JPanel top = new JPanel(new FlowLayout(FlowLayout.LEADING, 8, 6));
    top.add(button);
    top.add(state);
    JPanel below = new JPanel(new BorderLayout());
    below.add(charts, BorderLayout.NORTH);
    below.add(words, BorderLayout.CENTER);
    add(top, BorderLayout.NORTH);
    add(below, BorderLayout.CENTER);
  }

  /** Shows where a render stands: nothing is measured beside it. */
  void show(Snapshot s) {
    Prepared next = s.findings().map(Findings::prepared).orElse(null);
    boolean over = s.state().isOver() && next != null;
    if (!over) {
      cancel();
    }
    if (next != null && next != prepared) {
      prepared = next;
      charts.removeAll();
      words.setText("");
      state.setText(HINT);
      charts.revalidate();
    }
    button.setEnabled(over);
  }

  /** Begins to measure, or ends that. */
  void measureOrCancel() {
    if (run != null) {
      cancel();
      measures.accept(false);
    } else if (button.isEnabled()) {
      button.setText("Cancel");
      SpeedRun[] own = new SpeedRun[1];
      Latest<String> told = new Latest<>(text -> tell(own[0], text));
      own[0] =
          new SpeedRun(
              prepared, told, found -> SwingUtilities.invokeLater(() -> show(own[0], found)));
      run = own[0];
      measures.accept(true);
      run.start();
    }
  }

  private void cancel() {
    if (run != null) {
      run.cancel();
      end("cancelled");
    }
  }

  /** Ends what runs and forgets the scene. */
  void end() {
    cancel();
    prepared = null;
  }

  private void end(String how) {
    run = null;
    button.setText("Measure");
    state.setText(how);
  }

  private void tell(SpeedRun from, String text) {
    if (from == run) {
      state.setText(text);
    }
  }

  private void show(SpeedRun from, Optional<SpeedRun.Result> found) {
    if (from != run) {
      return; // cancelled
    }
    end("done");
    measures.accept(false);
    charts.removeAll();
    if (found.isPresent()) {
      charts.add(SpeedChart.of(found.get()), BorderLayout.CENTER);
      words.setText(words(found.get()));
      words.setCaretPosition(0);
    }
    revalidate();
    repaint();
  }

  private static String words(SpeedRun.Result found) {
    StringBuilder text = new StringBuilder("<table cellpadding=2>");
    text.append("<tr><th>goal</th><th>error</th><th>seconds</th><th>samples</th></tr>");
    for (TargetRuns runs : found.targets().runs()) {
      text.append(
          String.format(
              Locale.ROOT,
              "<tr align=right><td>%.2g</td><td>%.2g</td><td>%.2g</td><td>%.3g</td></tr>",
              runs.target(),
              runs.error().levels(),
              runs.cost(Cost.SECONDS),
              runs.samples()));
    }
    text.append("</table><p>Errors in display levels, of ");
    text.append(found.width()).append("x").append(found.height());
    text.append(" pixels against ").append(found.uniform().truth().origin()).append(".");
    found
        .uniform()
        .trend(Cost.SECONDS)
        .map(trend -> String.format(Locale.ROOT, " The slope is %.2f.", trend.law().slope()))
        .ifPresent(text::append);
    return text.toString();
  }
}

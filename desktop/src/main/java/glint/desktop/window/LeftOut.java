package glint.desktop.window;

import glint.scene.Decision;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JEditorPane;

/** What a render uses, and what it leaves out and why, in words. */
final class LeftOut extends JEditorPane {

  private static final long serialVersionUID = 1;

  private transient List<Decision> shown = List.of();

  /** Makes an empty one. */
  LeftOut() {
    super("text/html", "");
    putClientProperty(HONOR_DISPLAY_PROPERTIES, true);
    setName("plan");
    getAccessibleContext().setAccessibleName("What is used and what is left out");
    setEditable(false);
    setBorder(BorderFactory.createEmptyBorder(4, 10, 4, 10));
  }

  /** Shows decisions. */
  void show(List<Decision> decisions) {
    if (!decisions.equals(shown)) {
      shown = decisions;
      setText(list("Left out", decisions, false) + list("Used", decisions, true));
      setCaretPosition(0);
    }
  }

  private static String list(String title, List<Decision> all, boolean used) {
    return all.stream()
        .filter(decision -> decision.used() == used)
        .map(decision -> row(decision.feature(), decision.reason()))
        .collect(
            Collectors.joining("", "<div style='margin-top: 6'><b>" + title + "</b></div>", ""));
  }

  private static String row(String feature, String reason) {
    return "<div style='margin-top: 4'><i>" + feature + "</i>: " + Html.escaped(reason) + "</div>";
  }
}

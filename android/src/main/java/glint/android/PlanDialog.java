package glint.android;

import android.app.Activity;
import android.app.AlertDialog;
import glint.scene.Decision;
import java.util.ArrayList;
import java.util.List;

/** Tells what a scene needs, and what is left out for that. */
final class PlanDialog {

  private PlanDialog() {}

  /** Opens it. */
  static void show(Activity activity, List<Decision> plan) {
    List<String> lines = new ArrayList<>();
    for (Decision each : plan) {
      int words = each.used() ? R.string.used : R.string.left_out;
      lines.add(activity.getString(words, each.feature(), each.reason()));
    }
    new AlertDialog.Builder(activity)
        .setTitle(R.string.plan)
        .setItems(lines.toArray(new String[0]), null)
        .setPositiveButton(android.R.string.ok, null)
        .show();
  }
}

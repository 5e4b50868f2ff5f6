package glint.android;

import android.content.res.Resources;
import android.view.View;
import android.widget.ProgressBar;
import android.widget.TextView;
import glint.android.Status.State;

/** The lines below a picture: a bar, where the render stands, and its figures. */
final class StatusPanel {

  private static final int PARTS = 1000;

  private final Resources resources;
  private final ProgressBar bar;
  private final TextView state;
  private final TextView figures;
  private final TextView note;

  /** Finds the views of the panel. */
  StatusPanel(View screen) {
    resources = screen.getResources();
    bar = screen.findViewById(R.id.progress);
    state = screen.findViewById(R.id.state);
    figures = screen.findViewById(R.id.figures);
    note = screen.findViewById(R.id.note);
    bar.setMax(PARTS);
  }

  /** Tells how far a render has come. */
  void show(Session session) {
    if (session.isMoving()) {
      say(state, resources.getString(R.string.moving));
      return;
    }
    Status status = session.status();
    bar.setIndeterminate(!status.state().isOver() && status.part() == 0);
    bar.setProgress((int) (PARTS * status.part()));
    say(state, words(session, status.state()));
    say(figures, status.rays() == 0 ? "" : figures(status));
    String shrunk = resources.getString(R.string.shrunk, session.width(), session.height());
    say(note, session.isShrunk() ? shrunk : "");
    note.setVisibility(session.isShrunk() ? View.VISIBLE : View.GONE);
  }

  /** Sets a text if it is new: a screen reader speaks whatever is set. */
  private static void say(TextView view, String text) {
    if (!text.contentEquals(view.getText())) {
      view.setText(text);
    }
  }

  private String words(Session session, State state) {
    return switch (state) {
      case PREPARING -> resources.getString(R.string.preparing);
      case RENDERING -> resources.getString(R.string.rendering);
      case PAUSED -> resources.getString(R.string.paused);
      case DONE -> resources.getString(R.string.done);
      case STOPPED -> resources.getString(R.string.stopped);
      case OUT_OF_MEMORY -> failed(resources.getString(R.string.no_memory));
      case REFUSED -> failed(refusal(session));
    };
  }

  private String failed(String why) {
    return resources.getString(R.string.failed, why);
  }

  private String refusal(Session session) {
    long needed = Heap.needed(session.scene(), session.width(), session.height());
    long free = Heap.now().bytes();
    return resources.getString(R.string.too_big, Heap.mebibytes(needed), Heap.mebibytes(free));
  }

  private String figures(Status status) {
    double seconds = status.seconds();
    double rate = 1e-6 * status.rays() / Math.max(1e-3, seconds);
    String words = resources.getString(R.string.figures, seconds, rate);
    if (status.error() < Double.POSITIVE_INFINITY) {
      words = resources.getString(R.string.figures_and_error, words, status.error());
    }
    if (!status.state().isOver()
        && status.left() >= 1
        && status.left() < Double.POSITIVE_INFINITY) {
      words = resources.getString(R.string.figures_and_left, words, status.left());
    }
    return words;
  }
}

package glint.android;

import android.view.Menu;
import android.view.MenuItem;

/** The commands of a render's screen, as far as they make sense at the time. */
final class RenderMenu {

  private final Menu menu;
  private boolean over;
  private boolean paused;

  /** Takes over a menu that was just filled. */
  RenderMenu(Menu menu) {
    this.menu = menu;
    allow(false);
    show(true, false);
  }

  /** Enables what makes sense; the menu itself is told of changes only. */
  void update(Session session) {
    boolean nowOver = session.status().state().isOver();
    if (nowOver != over || session.isPaused() != paused) {
      show(nowOver, session.isPaused());
    }
    if (session.bitmap() != null && !menu.findItem(R.id.save).isEnabled()) {
      allow(true);
    }
  }

  private void allow(boolean picture) {
    menu.findItem(R.id.save).setEnabled(picture);
    menu.findItem(R.id.share).setEnabled(picture);
    menu.findItem(R.id.plan).setEnabled(picture);
    menu.findItem(R.id.reset).setEnabled(picture);
  }

  private void show(boolean nowOver, boolean nowPaused) {
    over = nowOver;
    paused = nowPaused;
    MenuItem pause = menu.findItem(R.id.pause).setVisible(!over);
    pause.setTitle(paused ? R.string.resume : R.string.pause);
    pause.setIcon(paused ? R.drawable.play : R.drawable.pause);
  }
}

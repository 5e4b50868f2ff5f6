package glint.desktop.window;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/**
 * Hands values to the event thread; one that is overtaken by a newer one is never seen there.
 *
 * @param <T> what is handed over
 */
final class Latest<T> implements Consumer<T> {

  private final AtomicReference<T> waiting = new AtomicReference<>();
  private final Consumer<T> receiver;

  Latest(Consumer<T> receiver) {
    this.receiver = receiver;
  }

  @Override
  public void accept(T value) {
    if (waiting.getAndSet(value) == null) {
      SwingUtilities.invokeLater(() -> receiver.accept(waiting.getAndSet(null)));
    }
  }
}

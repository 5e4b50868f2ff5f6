package glint.android;

import static org.junit.Assert.fail;
import static org.robolectric.Shadows.shadowOf;

import android.os.Looper;
import java.util.function.BooleanSupplier;

/** Waits for what other threads do, while the main thread goes on. */
final class Waiting {

  private static final long LONGEST_NANOS = 300_000_000_000L;

  private Waiting() {}

  /** Runs what comes to the main thread until something is so. */
  static void until(String what, BooleanSupplier isSo) {
    long end = System.nanoTime() + LONGEST_NANOS;
    while (!isSo.getAsBoolean()) {
      if (System.nanoTime() - end > 0) {
        fail("waited in vain until " + what);
      }
      try {
        Thread.sleep(2);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
      shadowOf(Looper.getMainLooper()).idle();
    }
  }
}

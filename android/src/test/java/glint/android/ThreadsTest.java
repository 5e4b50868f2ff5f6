package glint.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import android.os.Process;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;

/** Threads have the priority that they are made for. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34)
public final class ThreadsTest {

  private static int priority(int wanted) throws InterruptedException {
    int[] found = new int[1];
    Thread thread =
        Threads.of("glint-test", wanted)
            .newThread(() -> found[0] = Process.getThreadPriority(Process.myTid()));
    assertEquals("glint-test", thread.getName());
    assertTrue(thread.isDaemon());
    thread.start();
    thread.join();
    return found[0];
  }

  @Test
  public void threadsHaveTheirPriority() throws InterruptedException {
    assertEquals(Process.THREAD_PRIORITY_BACKGROUND, priority(Threads.BESIDES));
    assertEquals(1, priority(Threads.AWAITED));
  }
}

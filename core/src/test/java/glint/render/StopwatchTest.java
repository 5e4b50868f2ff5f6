package glint.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class StopwatchTest {

  @Test
  void itRunsBetweenGoAndStopAlone() throws InterruptedException {
    long begun = System.nanoTime();
    Stopwatch watch = new Stopwatch();
    watch.stop();
    assertEquals(0, watch.seconds());
    watch.go();
    Thread.sleep(30);
    watch.go();
    watch.stop();
    double first = watch.seconds();
    assertTrue(first >= 0.029, "a second go does not begin anew: " + first);
    Thread.sleep(30);
    watch.stop();
    assertEquals(first, watch.seconds());
    watch.go();
    Thread.sleep(30);
    double second = watch.seconds();
    double all = (System.nanoTime() - begun) * 1e-9;
    assertTrue(second >= first + 0.029, "it runs on: " + second);
    assertTrue(second <= all - 0.029, second + " of " + all);
  }
}

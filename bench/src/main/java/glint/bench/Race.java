package glint.bench;

import com.sun.management.OperatingSystemMXBean;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import java.lang.management.ManagementFactory;
import java.util.Set;

/**
 * Measures what a render to an error costs beside one of the same number of samples for every
 * pixel: CPU seconds on one thread, by turns, so that whatever else the machine does slows both.
 */
final class Race {

  private static final OperatingSystemMXBean SYSTEM =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  /** The samples per pixel of a uniform render that is timed. */
  private static final int TIMED = 4;

  private final Prepared scene;
  private final RenderSettings settings;
  private final Goal goal;
  private double targetSeconds;
  private double uniformSeconds;
  private int turns;

  Race(Prepared scene, RenderSettings settings, Goal goal) {
    this.scene = scene;
    this.settings = settings;
    this.goal = goal;
  }

  /** Runs both for so many seconds untimed, then for as many timed. */
  void run(double seconds) {
    for (int lap = 0; lap < 2; lap++) {
      targetSeconds = 0;
      uniformSeconds = 0;
      turns = 0;
      while (targetSeconds + uniformSeconds < seconds) {
        double start = cpuSeconds();
        render(scene, settings, goal, turns);
        double middle = cpuSeconds();
        render(scene, settings, new Goal.Samples(TIMED), turns);
        targetSeconds += middle - start;
        uniformSeconds += cpuSeconds() - middle;
        turns++;
      }
    }
  }

  /** Returns what a render to the error takes. */
  double targetSeconds() {
    return targetSeconds / turns;
  }

  /** Returns what a sample of every pixel takes. */
  double sampleSeconds() {
    return uniformSeconds / turns / TIMED;
  }

  /** Renders on one thread. */
  static RenderResult render(Prepared scene, RenderSettings settings, Goal goal, long seed) {
    RenderSettings single =
        new RenderSettings(
            settings.width(),
            settings.height(),
            goal,
            seed,
            settings.maxDepth(),
            1,
            settings.tileSize(),
            Set.of());
    return new Renderer(scene, single).render(Progress.NONE);
  }

  private static double cpuSeconds() {
    return SYSTEM.getProcessCpuTime() * 1e-9;
  }
}

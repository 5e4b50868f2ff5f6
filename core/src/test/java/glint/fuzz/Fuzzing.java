package glint.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/** Tries the scenes of many seeds on all cores, and reduces the first that fails. */
final class Fuzzing {

  /** How many seeds a thread takes at a time. */
  private static final int BLOCK = 1000;

  private static final int REPORTED = 500_000;

  private final long count;
  private final AtomicLong next = new AtomicLong();
  private final AtomicReference<AssertionError> failure = new AtomicReference<>();
  private long drawn;
  private long refused;
  private long rays;
  private long hits;
  private long shadowRays;

  /** Will try the seeds from 0 to below a multiple of 1000. */
  Fuzzing(long count) {
    this.count = count;
  }

  /** Runs to the end, or to a failure, which it throws. */
  void run() throws InterruptedException {
    List<Thread> threads = new ArrayList<>();
    for (int i = Runtime.getRuntime().availableProcessors(); i > 0; i--) {
      Thread thread = new Thread(this::work, "fuzz");
      thread.setDaemon(true);
      thread.start();
      threads.add(thread);
    }
    for (Thread thread : threads) {
      thread.join();
    }
    if (failure.get() != null) {
      throw failure.get();
    }
  }

  /** Returns the share of parts that their constructors refused. */
  double refusedShare() {
    return (double) refused / drawn;
  }

  /** Returns the share of rays that hit something. */
  double hitShare() {
    return (double) hits / rays;
  }

  /** Returns how many rays to lights there were for a scene. */
  double shadowRaysPerScene() {
    return (double) shadowRays / count;
  }

  private void work() {
    SceneDraw draw = new SceneDraw();
    Trial trial = new Trial();
    try {
      for (long s = next.getAndAdd(BLOCK); s < count; s = next.getAndAdd(BLOCK)) {
        for (long seed = s; seed < s + BLOCK && failure.get() == null; seed++) {
          tryOne(seed, draw, trial);
        }
        if (s > 0 && s % REPORTED == 0) {
          System.out.println(s + " scenes tried");
        }
      }
    } catch (RuntimeException | Error e) {
      failure.compareAndSet(null, new AssertionError("seed unknown: " + e, e));
    }
    add(draw, trial);
  }

  private synchronized void add(SceneDraw draw, Trial trial) {
    drawn += draw.drawn;
    refused += draw.refused;
    rays += trial.rays;
    hits += trial.hits;
    shadowRays += trial.shadowRays;
  }

  private void tryOne(long seed, SceneDraw draw, Trial trial) {
    FuzzScene scene = null;
    try {
      scene = draw.draw(seed);
      trial.run(scene);
    } catch (RuntimeException | Error e) {
      failure.compareAndSet(null, describe(seed, scene, e));
    }
  }

  private static AssertionError describe(long seed, FuzzScene scene, Throwable failed) {
    FuzzScene least = scene == null ? null : reduce(scene);
    Throwable why = least == null ? failed : outcome(least);
    String how = "; to see it again: new Trial().run(new SceneDraw().draw(" + seed + "L));\n";
    String text = "seed " + seed + how + why + "\nReduced to what still fails:\n" + least;
    return new AssertionError(text, why);
  }

  /** Leaves out surfaces and lights as long as it still fails. */
  private static FuzzScene reduce(FuzzScene scene) {
    FuzzScene least = scene;
    for (int part = scene.parts() - 1; part >= 0; part--) {
      FuzzScene less = least.without(part);
      least = outcome(less) == null ? least : less;
    }
    return least;
  }

  /** Returns what goes wrong, or null. */
  private static Throwable outcome(FuzzScene scene) {
    try {
      new Trial().run(scene);
      return null;
    } catch (RuntimeException | Error e) {
      return e;
    }
  }
}

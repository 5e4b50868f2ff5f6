package glint.bench;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Ray;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Glint's own search. */
final class GlintKernel implements Kernel {

  private final ThreadMXBean clock = ManagementFactory.getThreadMXBean();
  private final Intersector intersector;
  private final Ray ray = new Ray();
  private final Hit hit = new Hit();

  GlintKernel(Intersector intersector) {
    this.intersector = intersector;
  }

  @Override
  public String name() {
    return "Glint";
  }

  @Override
  public Took trace(Rays rays) {
    long began = clock.getCurrentThreadCpuTime();
    int hits = rays.any() ? any(rays.data()) : closest(rays.data());
    return new Took((clock.getCurrentThreadCpuTime() - began) * 1e-9, hits);
  }

  private int closest(double[] data) {
    int hits = 0;
    for (int at = 0; at < data.length; at += Rays.SIZE) {
      set(data, at);
      intersector.closest(ray, data[at + 6], hit);
      hits += hit.found() ? 1 : 0;
    }
    return hits;
  }

  private int any(double[] data) {
    int hits = 0;
    for (int at = 0; at < data.length; at += Rays.SIZE) {
      set(data, at);
      hits += intersector.any(ray, data[at + 6], hit) ? 1 : 0;
    }
    return hits;
  }

  private void set(double[] data, int at) {
    ray.set(data[at], data[at + 1], data[at + 2], data[at + 3], data[at + 4], data[at + 5]);
  }
}

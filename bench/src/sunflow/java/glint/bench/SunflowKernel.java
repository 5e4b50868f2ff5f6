package glint.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.sunflow.core.IntersectionState;
import org.sunflow.core.ParameterList;
import org.sunflow.core.ParameterList.InterpolationType;
import org.sunflow.core.Ray;
import org.sunflow.core.accel.KDTree;
import org.sunflow.core.primitive.TriangleMesh;

/** Sunflow's kd-tree over its triangle mesh; compiled where Sunflow is installed. */
public final class SunflowKernel implements Kernel {

  private final ThreadMXBean clock = ManagementFactory.getThreadMXBean();
  private final KDTree tree = new KDTree();
  private final IntersectionState state = new IntersectionState();

  /** Builds the tree over triangles of nine numbers each. */
  public SunflowKernel(float[] points) {
    int[] corners = new int[points.length / 3];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = i;
    }
    ParameterList parameters = new ParameterList();
    parameters.addPoints("points", InterpolationType.VERTEX, points);
    parameters.addIntegerArray("triangles", corners);
    TriangleMesh triangles = new TriangleMesh();
    triangles.update(parameters, null);
    tree.build(triangles);
  }

  @Override
  public String name() {
    return "Sunflow, kd-tree";
  }

  @Override
  public Took trace(Rays rays) {
    double[] d = rays.data();
    long began = clock.getCurrentThreadCpuTime();
    int hits = 0;
    for (int at = 0; at < d.length; at += Rays.SIZE) {
      // There is no other search than for the closest hit, which becomes the ray's end.
      Ray ray =
          new Ray(
              (float) d[at],
              (float) d[at + 1],
              (float) d[at + 2],
              (float) d[at + 3],
              (float) d[at + 4],
              (float) d[at + 5]);
      float end = (float) d[at + 6];
      ray.setMinMax(1e-5f, end);
      tree.intersect(ray, state);
      hits += ray.getMax() < end ? 1 : 0;
    }
    return new Took((clock.getCurrentThreadCpuTime() - began) * 1e-9, hits);
  }
}

package glint.geometry;

import java.util.Arrays;

/**
 * Whether triangles close a body: every edge is walked as often one way as the other.
 *
 * <p>Corners at the same place are one corner, whatever their numbers.
 */
final class MeshEdges {

  private static final long CORNER = 0x7fffffffL;

  private MeshEdges() {}

  /** Returns whether no edge is open; without triangles there is no body. */
  static boolean areClosed(double[] points, int[] corners) {
    int[] place = Places.of(points);
    // An edge is its lower corner, its higher corner, and one bit for the way it is walked.
    long[] edges = new long[corners.length];
    for (int i = 0; i < corners.length; i++) {
      long from = place[corners[i]];
      long to = place[corners[i % 3 == 2 ? i - 2 : i + 1]];
      edges[i] = from < to ? from << 32 | to << 1 : to << 32 | from << 1 | 1;
    }
    Arrays.sort(edges);
    long ahead = 0;
    for (int i = 0; i < edges.length; i++) {
      boolean isPoint = edges[i] >>> 32 == (edges[i] >>> 1 & CORNER);
      ahead += isPoint ? 0 : (edges[i] & 1) == 0 ? 1 : -1;
      boolean isLast = i + 1 == edges.length || edges[i] >>> 1 != edges[i + 1] >>> 1;
      if (isLast && ahead != 0) {
        return false;
      }
    }
    return corners.length > 0;
  }
}

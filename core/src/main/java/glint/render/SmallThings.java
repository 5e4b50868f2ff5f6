package glint.render;

import glint.geometry.Mesh;
import glint.geometry.Outline;
import glint.geometry.Surface;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.View;
import glint.trace.Tracer;
import java.util.List;
import java.util.Map;

/**
 * Finds by projection where things may be seen that are too small or too thin for the rays through
 * the pixels' corners.
 *
 * <p>Every convex surface, every lamp and every triangle of a mesh is projected onto the image. A
 * part of a pixel that it covers is such a place if no corner of the pixel lies in it, or if all of
 * the surface is less than a pixel wide. Of a mesh, whose triangles are small anyway, no corner of
 * the pixel may see it, or all corners of no pixel around. Whether anything is really seen there is
 * for a ray to find out.
 */
final class SmallThings {

  /** Shadows that are wider, in pixels, are not looked at: their corners may be anywhere. */
  private static final double NARROW = 2;

  /** The most triangles of meshes that are looked at. */
  private static final int MOST_TRIANGLES = 1 << 22;

  private final Prepared scene;
  private final View view;
  private final CornerGrid corners;
  private final int width;
  private final int height;
  private final Silhouette silhouette;
  private final CastShadow shadow;
  private final ConvexPolygon whole;
  private final Glimpses glimpses;
  private int triangles;

  SmallThings(Prepared scene, View view, CornerGrid corners) {
    this.scene = scene;
    this.view = view;
    this.corners = corners;
    silhouette = new Silhouette(view);
    whole = silhouette.whole;
    shadow = new CastShadow(scene, view.eye());
    width = corners.stride - 1;
    height = corners.rows - 1;
    glimpses = new Glimpses(width, height);
  }

  /** Returns by pixel, in row order, what may be seen there; nothing is small behind a lens. */
  Map<Integer, List<Glimpses.Glimpse>> find() {
    if (!view.isSharp()) {
      return Map.of();
    }
    int surface = 0;
    for (Placement p : scene.scene().placements()) {
      if (p.surface() instanceof Mesh mesh) {
        mesh(mesh, p, surface);
      } else {
        convex(p.surface(), p.toWorld(), surface);
        shadows(p, surface);
      }
      surface += p.materials().size();
    }
    for (int i = 0; i < scene.lights().count(); i++) {
      if (scene.lights().shape(i) != null) {
        convex(scene.lights().shape(i), Transform.IDENTITY, Tracer.lamp(i));
      }
    }
    return glimpses.byPixel();
  }

  private void convex(Surface shape, Transform toWorld, int surface) {
    List<Vector3d> outline = Outline.of(shape, toWorld, view.eye());
    if (!outline.isEmpty()) {
      silhouette.project(outline);
      whole.close();
      glimpses.add(whole, surface, false, (x, y) -> true);
    }
  }

  /** Looks for the shadows of a convex surface. */
  private void shadows(Placement p, int surface) {
    if (!scene.plan().shadows().used()) {
      return;
    }
    for (int light = 0; light < scene.lights().count(); light++) {
      if (scene.lights().shape(light) == null) {
        List<Vector3d> outline = shadow.of(p, surface, light);
        if (!outline.isEmpty()) {
          silhouette.project(outline);
          whole.close();
          if (whole.width() < NARROW) {
            int onto = shadow.fallsOnto();
            glimpses.add(whole, surface, true, (x, y) -> seen(x, y, onto) > 0);
          }
        }
      }
    }
  }

  private void mesh(Mesh mesh, Placement p, int first) {
    triangles += mesh.triangles();
    if (triangles > MOST_TRIANGLES) {
      return;
    }
    double[] m = p.toWorld().rows();
    double[] nine = new double[9];
    double[] places = new double[9];
    for (int i = 0; i < mesh.triangles(); i++) {
      mesh.corners(i, nine);
      for (int j = 0; j < 9; j += 3) {
        double x = nine[j];
        double y = nine[j + 1];
        double z = nine[j + 2];
        places[j] = m[0] * x + m[1] * y + m[2] * z + m[3];
        places[j + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
        places[j + 2] = m[8] * x + m[9] * y + m[10] * z + m[11];
      }
      silhouette.project(places);
      int surface = p.materials().size() > 1 ? first + mesh.part(i) : first;
      if (!isPlain(surface)) {
        whole.close();
        boolean thin = whole.width() < Glimpses.THIN;
        glimpses.add(
            whole,
            surface,
            false,
            (x, y) -> thin ? isSparse(x, y, surface) : seen(x, y, surface) == 0);
      }
    }
  }

  /** Returns whether a triangle lies in one pixel, where it is nothing special or not seen. */
  private boolean isPlain(int surface) {
    int x = (int) Math.floor(whole.least(false));
    int y = (int) Math.floor(whole.least(true));
    if (!(whole.greatest(false) < x + 1 && whole.greatest(true) < y + 1)) {
      return false;
    }
    return x < 0 || y < 0 || x >= width || y >= height || !isSparse(x, y, surface);
  }

  /** Returns whether no corner of a pixel sees a surface, or some do but all of none around. */
  private boolean isSparse(int x, int y, int surface) {
    int here = seen(x, y, surface);
    if (here == 0 || here == 4) {
      return here == 0;
    }
    for (int row = Math.max(0, y - 1); row <= Math.min(height - 1, y + 1); row++) {
      for (int column = Math.max(0, x - 1); column <= Math.min(width - 1, x + 1); column++) {
        if (seen(column, row, surface) == 4) {
          return false;
        }
      }
    }
    return true;
  }

  /** Returns how many corners of a pixel see a surface. */
  private int seen(int x, int y, int surface) {
    int[] first = corners.first;
    int a = y * corners.stride + x;
    int c = a + corners.stride;
    int count = first[a] == surface ? 1 : 0;
    count += first[a + 1] == surface ? 1 : 0;
    count += first[c] == surface ? 1 : 0;
    return count + (first[c + 1] == surface ? 1 : 0);
  }
}

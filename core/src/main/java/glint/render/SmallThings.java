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
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

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

  /**
   * What may be seen in a part of a pixel.
   *
   * @param surface its number
   * @param shadow whether it is the shadow of that surface that may be seen
   */
  record Glimpse(int surface, boolean shadow, ConvexPolygon part) {}

  /**
   * A surface at least as wide as this, in pixels, covers a corner of most pixels that it meets.
   */
  private static final double THIN = 1;

  /** Shadows that are wider, in pixels, are not looked at: their corners may be anywhere. */
  private static final double NARROW = 2;

  /** Less of a pixel is nothing. */
  private static final double LEAST_AREA = 1e-6;

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
  private final ConvexPolygon inImage = new ConvexPolygon();
  private final ConvexPolygon band = new ConvexPolygon();
  private final double[] above = new double[2];
  private final double[] below = new double[2];

  /** By pixel, what may be seen there. */
  private final Map<Integer, List<Glimpse>> glimpses = new TreeMap<>();

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
  }

  /** Returns by pixel, in row order, what may be seen there; nothing is small behind a lens. */
  Map<Integer, List<Glimpse>> find() {
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
    return glimpses;
  }

  private void convex(Surface shape, Transform toWorld, int surface) {
    List<Vector3d> outline = Outline.of(shape, toWorld, view.eye());
    if (!outline.isEmpty()) {
      silhouette.project(outline);
      look(surface, false, false);
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
            look(surface, false, true);
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
      look(p.materials().size() > 1 ? first + mesh.part(i) : first, true, false);
    }
  }

  /** Notes the pixels that may show too little of a surface whose outline was found. */
  private void look(int surface, boolean ofMesh, boolean ofShadow) {
    if (ofMesh && isPlain(surface)) {
      return;
    }
    whole.close();
    inImage.clip(whole, 0, 0, width, height);
    if (inImage.isEmpty()) {
      return;
    }
    boolean thin = whole.width() < THIN;
    int top = (int) inImage.least(true);
    int bottom = Math.min(height - 1, (int) inImage.greatest(true));
    for (int y = top; y <= bottom; y++) {
      band.clip(inImage, 0, y, width, y + 1);
      if (band.isEmpty()) {
        continue;
      }
      inImage.span(y, above);
      inImage.span(y + 1, below);
      int left = (int) band.least(false);
      int right = Math.min(width - 1, (int) band.greatest(false));
      for (int x = left; x <= right; x++) {
        int covered = thin ? -1 : Math.max(coveredUpTo(x, above), coveredUpTo(x, below));
        if (covered >= x) {
          x = covered;
        } else if (!ofMesh || (thin ? isSparse(x, y, surface) : seen(x, y, surface) == 0)) {
          note(x, y, surface, ofShadow);
        }
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

  /**
   * Returns the last pixel of a row up to which all have a corner on a covered part of the row's
   * upper or lower line, from one on; less if that one has none.
   */
  private static int coveredUpTo(int x, double[] span) {
    boolean left = span[0] <= x && x <= span[1];
    boolean right = span[0] <= x + 1 && x + 1 <= span[1];
    return left || right ? (int) Math.floor(span[1]) : -1;
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

  /** Adds a part of a pixel to what may be seen of a surface there. */
  private void note(int x, int y, int surface, boolean ofShadow) {
    ConvexPolygon part = new ConvexPolygon();
    part.clip(band, x, y, x + 1, y + 1);
    if (part.area() < LEAST_AREA) {
      return;
    }
    List<Glimpse> here = glimpses.computeIfAbsent(y * width + x, k -> new ArrayList<>(1));
    for (Glimpse each : here) {
      if (each.surface() == surface && each.shadow() == ofShadow) {
        each.part().add(part);
        each.part().close();
        return;
      }
    }
    here.add(new Glimpse(surface, ofShadow, part));
  }
}

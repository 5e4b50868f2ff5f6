package glint.render;

import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.image.Image;
import glint.optics.Texel;
import glint.scene.Prepared;
import java.util.Map;

/** Fills the extra pictures of what the ray through each pixel's centre sees first. */
final class Looker {

  private final Prepared scene;
  private final Map<Aov, Image> aovs;
  private final boolean needed;
  private final Ray ray = new Ray();
  private final Texel pattern = new Texel();

  Looker(Prepared scene, Map<Aov, Image> aovs) {
    this.scene = scene;
    this.aovs = aovs;
    needed = aovs.keySet().stream().anyMatch(Aov::isOfScene);
  }

  /** Looks through a pixel's centre, if there are pictures of the scene to fill. */
  void look(Probe probe, int x, int y) {
    if (!needed) {
      return;
    }
    Hit hit = probe.look(x + 0.5, y + 0.5, ray);
    double dx = ray.dx;
    double dy = ray.dy;
    double dz = ray.dz;
    for (Map.Entry<Aov, Image> aov : aovs.entrySet()) {
      Image target = aov.getValue();
      switch (aov.getKey()) {
        case DEPTH -> grey(target, x, y, hit.found() ? hit.t : Double.POSITIVE_INFINITY);
        case ID -> grey(target, x, y, hit.found() ? scene.place(hit.surface) : -1);
        case NORMAL -> {
          if (hit.found()) {
            double side = dx * hit.nx + dy * hit.ny + dz * hit.nz > 0 ? -1 : 1;
            target.set(x, y, side * hit.nx, side * hit.ny, side * hit.nz);
          }
        }
        case ALBEDO -> {
          if (hit.found()) {
            Rgb diffuse = scene.material(hit.surface).diffuse();
            scene.texture(hit.surface, hit, pattern);
            target.set(
                x, y, diffuse.r() * pattern.r, diffuse.g() * pattern.g, diffuse.b() * pattern.b);
          }
        }
        default -> {} // pictures of the render, not of the scene
      }
    }
  }

  private static void grey(Image target, int x, int y, double v) {
    target.set(x, y, v, v, v);
  }
}

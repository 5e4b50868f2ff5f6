package glint.trace;

import glint.accel.Intersector;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.optics.Fresnel;
import glint.optics.Material;
import glint.optics.Medium;
import glint.scene.Prepared;
import java.util.Arrays;

/**
 * What a ray meets at one place: all transparent surfaces within the rounding of one hit, as one
 * event; scratch.
 *
 * <p>Coincident faces are crossed together, in order of t and then of primitives, so that two slabs
 * that share a plane are one body, and a glass on a table has no gap.
 */
final class Boundary {

  private final Prepared scene;
  private final Intersector intersector;

  /** What is crossed last; once crossed, the ray goes on after it. */
  final Hit last = new Hit();

  /** The media beyond. */
  final Interior beyond;

  /** The surface whose material decides; the opaque one, if any coincides. */
  int surface;

  /** Whether an opaque surface is met: nothing is crossed. */
  boolean opaque;

  /** Whether something is seen there, rather than a boundary hidden in another medium. */
  boolean visible;

  /** Whether several surfaces coincide. */
  boolean several;

  /** The index of refraction before over that beyond. */
  double eta;

  /** The surfaces crossed here, and for each whether that leads in (1), out (-1) or back (0). */
  private int[] crossed = new int[8];

  private int[] balance = new int[8];
  private int crossings;

  Boundary(Prepared scene, Intersector intersector) {
    this.scene = scene;
    this.intersector = intersector;
    beyond = new Interior(scene);
  }

  /**
   * Meets the surfaces at a hit. Where one is opaque, {@link #beyond} is what lies before it.
   *
   * @param ray the ray that hit; it goes on after what was crossed
   * @param end where the ray ends
   * @param hit the first hit, resolved; replaced by an opaque one that coincides, and told which
   *     part of the surface that decides is there
   * @param interior the media before
   */
  void meet(Ray ray, double end, Hit hit, Interior interior) {
    surface = hit.surface;
    several = false;
    beyond.copy(interior);
    opaque = !scene.material(surface).isTransparent();
    if (opaque) {
      return;
    }
    int before = interior.current();
    crossings = 0;
    cross(hit);
    visible = scene.isOpen(surface) || scene.mediumOf(surface) == Prepared.OUTSIDE;
    ray.goOnAfter(hit);
    double reach = Math.min(end, hit.t + hit.clearance(ray));
    boolean alone = intersector.isAlone(hit, reach);
    while (!alone) {
      intersector.closest(ray, reach, last);
      if (!last.found()) {
        break;
      }
      alone = intersector.isAlone(last, reach);
      intersector.resolve(ray, last);
      several = true;
      ray.goOnAfter(last);
      if (!scene.material(last.surface).isTransparent()) {
        surface = last.surface;
        opaque = true;
        hit.copy(last);
        scene.face(ray, hit);
        return;
      }
      cross(last);
      visible |= scene.isOpen(last.surface) || scene.mediumOf(last.surface) == Prepared.OUTSIDE;
      if (priority(last.surface) > priority(surface)) {
        surface = last.surface;
        hit.copyPart(last);
      }
    }
    int after = beyond.current();
    visible |= before != after;
    eta = scene.medium(before).ior() / scene.medium(after).ior();
  }

  /**
   * Goes in or out of a surface's medium, but not twice the same way: a ray through an edge meets
   * both faces.
   */
  private void cross(Hit hit) {
    int medium = scene.mediumOf(hit.surface);
    if (medium == Prepared.OUTSIDE || hit.crossing == 0) {
      return;
    }
    int i = 0;
    while (i < crossings && crossed[i] != hit.surface) {
      i++;
    }
    if (i == crossed.length) {
      crossed = Arrays.copyOf(crossed, 2 * i);
      balance = Arrays.copyOf(balance, 2 * i);
    }
    if (i == crossings) {
      crossed[crossings++] = hit.surface;
      balance[i] = 0;
    }
    if (balance[i] != hit.crossing) {
      balance[i] += hit.crossing;
      if (hit.crossing > 0) {
        beyond.enter(medium);
      } else {
        beyond.leave(medium);
      }
    }
  }

  private int priority(int number) {
    Medium interior = scene.material(number).interior();
    return interior.priority();
  }

  /**
   * Returns the share that Fresnel's law reflects of a straight shadow ray.
   *
   * <p>The angle counts as that on the side of the lower index, at entry and exit alike, so that
   * nothing is reflected totally on the way to a light.
   */
  double shadowReflectance(double cos) {
    double rising = Math.min(eta, 1 / eta);
    return Fresnel.reflectance(cos, Fresnel.cosOut(cos, rising), rising);
  }

  Material material() {
    return scene.material(surface);
  }
}

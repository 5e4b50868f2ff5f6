package glint.trace;

import glint.color.Rgb;
import glint.math.Vector3d;
import glint.optics.Medium;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A ray, all that became of it, and the rays that came of it; immutable.
 *
 * @param number of the ray in its tree, depth first, from 1
 * @param parent the number of the ray that it came of, 0 for a camera ray
 * @param bounces how many bounces led here
 * @param origin a point of world space
 * @param direction of unit length
 * @param weight the share of its radiance, at the origin, that reaches the eye
 * @param passed boundaries on its way that are not seen, hidden in another medium
 * @param met the surface that it ends at, if any
 * @param lamp the number in the scene of the light that it ends at, if any; else, if no surface
 *     either, it ends in the background
 * @param sight what it sees at its end
 * @param cuts what could come of it and is not followed
 * @param children the rays that came of it, in the order in which they were followed
 */
public record RayTree(
    int number,
    int parent,
    Kind kind,
    int bounces,
    Vector3d origin,
    Vector3d direction,
    Rgb weight,
    List<Meeting> passed,
    Optional<Meeting> met,
    OptionalInt lamp,
    Sight sight,
    List<Cut> cuts,
    List<RayTree> children) {

  /** How a ray came to be. */
  public enum Kind {
    CAMERA,
    REFLECTION,
    REFRACTION,
    /** On through a boundary between equal indices, on the very same line. */
    STRAIGHT
  }

  /**
   * What a ray meets at one place.
   *
   * @param surface the number of the surface in the prepared scene; of several, that whose material
   *     counts
   * @param several whether surfaces coincide there
   * @param t the distance from the ray's origin
   * @param normal the surface's own, of unit length, on the ray's side
   * @param shading the normal that light goes by; another one where a mesh stands for a curve
   * @param cos the cosine of the angle between the ray and that
   * @param before the medium on the ray's side
   * @param boundary what is beyond, unless the surface is opaque
   */
  public record Meeting(
      int surface,
      boolean several,
      double t,
      Vector3d point,
      Vector3d normal,
      Vector3d shading,
      double cos,
      Medium before,
      Optional<Boundary> boundary) {}

  /**
   * The way through a surface.
   *
   * @param beyond the medium there
   * @param eta the index of refraction before over that beyond
   * @param reflected the share, 0 to 1, that Fresnel's law reflects
   */
  public record Boundary(Medium beyond, double eta, double reflected) {}

  /**
   * What a ray sees at its end.
   *
   * @param weight the share of it that reaches the eye, absorption on the way included
   * @param pattern what a texture multiplies the surface's colour by; white without one
   * @param own the background, a light that is seen, or what a surface gives whether lit or not:
   *     emission, ambient light
   * @param lights what each light adds; none where the surface answers none
   * @param radiance all of it
   */
  public record Sight(Rgb weight, Rgb pattern, Rgb own, List<Lighting> lights, Rgb radiance) {

    /** Returns what it adds to the sample. */
    public Rgb contribution() {
      return radiance.times(weight);
    }
  }

  /** What becomes of a light at a point. */
  public enum Fate {
    LIT,
    /** Something between takes all of it. */
    SHADOWED,
    /** It is behind the surface. */
    BEHIND,
    /** It sends nothing there. */
    DARK
  }

  /**
   * One light at a point of a surface.
   *
   * @param light the number of the light in the scene, from 0
   * @param towards the unit vector to the light; zero if it is dark
   * @param cos of the angle between it and the normal
   * @param crossings what the light passes through, as seen from the surface; if shadowed by
   *     something opaque, that is the last
   * @param passing the share that passes, by channel
   * @param added what the surface gives for it
   */
  public record Lighting(
      int light,
      Fate fate,
      Vector3d towards,
      double cos,
      List<Crossing> crossings,
      Rgb passing,
      Rgb added) {}

  /**
   * A surface on the way to a light.
   *
   * @param reflected the share that Fresnel's law reflects
   * @param passing the share of the light that is left behind it; none if it is opaque
   */
  public record Crossing(int surface, Vector3d point, double reflected, Rgb passing) {}

  /** Why a ray is not followed. */
  public enum Reason {
    /** It would be one bounce too many. */
    DEPTH,
    /** What it could bring is too little. */
    CONTRIBUTION
  }

  /**
   * A ray that is not followed.
   *
   * @param weight the share of its radiance that would reach the eye
   * @param missing the most that it could bring, in any channel
   */
  public record Cut(Kind kind, Reason reason, Rgb weight, double missing) {}

  /** Makes lists that nobody changes. */
  public RayTree {
    passed = List.copyOf(passed);
    cuts = List.copyOf(cuts);
    children = List.copyOf(children);
  }

  /** Returns the ray and all that came of it, in the order in which they were followed. */
  public List<RayTree> rays() {
    List<RayTree> rays = new ArrayList<>();
    Deque<RayTree> next = new ArrayDeque<>();
    next.push(this);
    while (!next.isEmpty()) {
      RayTree ray = next.pop();
      rays.add(ray);
      for (int i = ray.children.size() - 1; i >= 0; i--) {
        next.push(ray.children.get(i));
      }
    }
    return rays;
  }

  /** Returns the sum of all contributions: bit for bit what the tracer finds for this ray. */
  public Rgb radiance() {
    Rgb sum = Rgb.BLACK;
    for (RayTree ray : rays()) {
      sum = sum.plus(ray.sight.contribution());
    }
    return sum;
  }
}

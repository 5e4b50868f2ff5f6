package glint.light;

import glint.accel.Parts;
import glint.accel.Pencil;
import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Primitives;
import glint.geometry.Ray;
import glint.geometry.Surface;
import glint.math.Vector3d;
import glint.sampling.SobolSampler;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** The lights of a scene in the form that shading touches: flat arrays, and the ambient sum. */
public final class Illumination {

  private static final byte POINT = 0;
  private static final byte INVERSE_SQUARE = 1;
  private static final byte DIRECTIONAL = 2;
  private static final byte SPOT = 3;
  private static final byte LAMP = 4;

  private final Rgb ambient;
  private final byte[] kind;

  /** A light's number in the scene. */
  private final int[] number;

  private final Rgb[] color;

  /** A light's position, or for a directional light the unit vector towards it. */
  private final Vector3d[] where;

  /** A spot's unit axis, and the cosines at which it begins and ends to fade. */
  private final Vector3d[] axis;

  private final double[] cosInner;
  private final double[] cosOuter;

  /** Lights with an area; null in the place of others. */
  private final Lamp[] lamp;

  private final int lamps;

  /** Sums up the ambient lights and flattens the others; black ones are left out. */
  public Illumination(List<Light> lights) {
    Rgb sum = Rgb.BLACK;
    List<Integer> others = new ArrayList<>();
    for (int i = 0; i < lights.size(); i++) {
      Light light = lights.get(i);
      if (light instanceof Light.Ambient) {
        sum = sum.plus(light.color());
      } else if (!light.color().isBlack()) {
        others.add(i);
      }
    }
    ambient = sum;
    int n = others.size();
    kind = new byte[n];
    number = new int[n];
    color = new Rgb[n];
    where = new Vector3d[n];
    axis = new Vector3d[n];
    cosInner = new double[n];
    cosOuter = new double[n];
    lamp = new Lamp[n];
    for (int i = 0; i < n; i++) {
      number[i] = others.get(i);
      flatten(i, lights.get(number[i]));
    }
    lamps = (int) Arrays.stream(lamp).filter(Objects::nonNull).count();
  }

  private void flatten(int i, Light light) {
    color[i] = light.color();
    if (light instanceof Light.Point p) {
      kind[i] = p.inverseSquare() ? INVERSE_SQUARE : POINT;
      where[i] = p.position();
    } else if (light instanceof Light.Directional d) {
      kind[i] = DIRECTIONAL;
      where[i] = d.direction().normalized().negated();
    } else if (light instanceof Light.Spot s) {
      kind[i] = SPOT;
      where[i] = s.position();
      axis[i] = s.lookAt().minus(s.position()).normalized();
      double half = StrictMath.toRadians(s.angle() / 2);
      cosOuter[i] = StrictMath.cos(half);
      cosInner[i] = StrictMath.cos(half * (1 - s.softness()));
    } else if (light instanceof Light.Sphere s) {
      kind[i] = LAMP;
      lamp[i] = new BallLamp(s.center(), s.radius());
    } else if (light instanceof Light.Rectangle r) {
      kind[i] = LAMP;
      lamp[i] = new PanelLamp(r.corner(), r.edge1(), r.edge2());
    }
  }

  /** Returns the sum of the ambient lights. */
  public Rgb ambient() {
    return ambient;
  }

  /** Returns the number of lights that come from somewhere. */
  public int count() {
    return kind.length;
  }

  /** Returns how many of them have an area. */
  public int lamps() {
    return lamps;
  }

  /** Returns the most radiance, in any channel, of a light that is seen. */
  public double brightestLamp() {
    double most = 0;
    for (int i = 0; i < kind.length; i++) {
      most = kind[i] == LAMP ? Math.max(most, color[i].max()) : most;
    }
    return most;
  }

  /** Returns what rays meet of a light, or null if it has no area. */
  public Surface shape(int i) {
    return lamp[i] == null ? null : lamp[i].shape();
  }

  /** Returns whether a light without an area sends parallel rays from everywhere. */
  public boolean isFar(int i) {
    return kind[i] == DIRECTIONAL;
  }

  /** Returns the way of light from a light without an area to a point; from afar, of length 1. */
  public Vector3d way(int i, Vector3d to) {
    return isFar(i) ? where[i].negated() : to.minus(where[i]);
  }

  /** Returns the colour of a light. */
  Rgb color(int i) {
    return color[i];
  }

  /** Returns the number of a light in the scene, from 0. */
  public int number(int i) {
    return number[i];
  }

  /**
   * Computes what a light sends to a point, shadows aside; of one with an area, what a random place
   * of it stands for.
   *
   * @param path a number of its own for the ray that has met the point
   * @return whether it sends anything; not if the light is at the point itself, or so near that the
   *     square of the distance has no full precision, where it has no direction
   */
  public boolean at(int i, Hit hit, SobolSampler numbers, long path, LightSample out) {
    if (kind[i] == LAMP) {
      numbers.draw(path + i);
      double strength = lamp[i].sample(hit, numbers, out);
      out.shine(color[i], strength);
      return strength > 0;
    }
    Vector3d w = where[i];
    Rgb c = color[i];
    if (kind[i] == DIRECTIONAL) {
      out.set(w.x(), w.y(), w.z(), c, 1);
      return true;
    }
    double x = w.x() - hit.px;
    double y = w.y() - hit.py;
    double z = w.z() - hit.pz;
    double squared = x * x + y * y + z * z;
    double distance = Math.sqrt(squared);
    if (!(squared >= Double.MIN_NORMAL)) {
      return false;
    }
    double strength = 1;
    if (kind[i] == INVERSE_SQUARE) {
      strength = 1 / squared;
    } else if (kind[i] == SPOT) {
      Vector3d a = axis[i];
      strength = fade(i, -(x * a.x() + y * a.y() + z * a.z()) / distance);
    }
    out.set(x / distance, y / distance, z / distance, c, strength);
    return strength > 0;
  }

  /** Returns a spot's share at an angle off its axis: a cubic smooth step from rim to core. */
  private double fade(int i, double cos) {
    if (cos >= cosInner[i]) {
      return 1;
    }
    if (cos <= cosOuter[i]) {
      return 0;
    }
    double s = (cos - cosOuter[i]) / (cosInner[i] - cosOuter[i]);
    return s * s * (3 - 2 * s);
  }

  /**
   * Sets {@code ray} to the shadow ray from a hit to a light.
   *
   * @param sample what {@link #at} found
   * @return the last parameter before the light
   */
  public double shadowRay(int i, LightSample sample, Hit hit, Ray ray) {
    if (kind[i] == LAMP) {
      return hit.spawnTo(sample.px, sample.py, sample.pz, ray);
    }
    Vector3d w = where[i];
    if (kind[i] == DIRECTIONAL) {
      hit.spawnToLight(w.x(), w.y(), w.z(), ray);
      return Double.POSITIVE_INFINITY;
    }
    return hit.spawnTo(w.x(), w.y(), w.z(), ray);
  }

  /**
   * Returns the shadow rays to a light, or null if it has an area.
   *
   * @param parts of which lists are to be made in place of primitives, or null
   */
  public Pencil pencil(int i, Primitives primitives, Parts parts) {
    return switch (kind[i]) {
      case LAMP -> null;
      case DIRECTIONAL -> Pencil.along(where[i], primitives, parts);
      default -> Pencil.to(where[i], primitives, parts);
    };
  }

  /**
   * Returns an upper bound on the light, summed over lights, that any point can receive. Of a
   * lamp's a surface gives back its integral over at most a hemisphere, 2π, divided by π.
   */
  public Rgb bound() {
    Rgb sum = Rgb.BLACK;
    for (int i = 0; i < kind.length; i++) {
      sum =
          switch (kind[i]) {
            case INVERSE_SQUARE -> sum.plus(Rgb.grey(Double.POSITIVE_INFINITY));
            case LAMP -> sum.plus(color[i]).plus(color[i]);
            default -> sum.plus(color[i]);
          };
    }
    return sum;
  }
}

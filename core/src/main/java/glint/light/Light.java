package glint.light;

import glint.color.Rgb;
import glint.math.BadValueException;
import glint.math.Check;
import glint.math.Vector3d;

/** A source of light as a person writes it; immutable. Colours are linear RGB, zero or more. */
public sealed interface Light {

  /** Returns the light's colour. */
  Rgb color();

  /** Light from everywhere, in the same strength. */
  record Ambient(Rgb color) implements Light {
    /** Checks the colour. */
    public Ambient {
      color.requireLight("color");
    }
  }

  /**
   * Light from one point; with {@code inverseSquare} it is {@code color / d²} at distance d.
   *
   * <p>Without, it is {@code color} at every distance.
   */
  record Point(Vector3d position, Rgb color, boolean inverseSquare) implements Light {
    /** Checks position and colour. */
    public Point {
      Check.finite("position", position);
      color.requireLight("color");
    }
  }

  /** Parallel light that travels along {@code direction} (any length but zero). */
  record Directional(Vector3d direction, Rgb color) implements Light {
    /** Checks direction and colour. */
    public Directional {
      Check.direction("direction", direction);
      color.requireLight("color");
    }
  }

  /**
   * A sphere that shines outwards with radiance {@code color}; no surface, so that it is in
   * nobody's light.
   */
  record Sphere(Vector3d center, double radius, Rgb color) implements Light {
    /** Checks place, size and colour. */
    public Sphere {
      Check.finite("center", center);
      Check.positive("radius", radius);
      color.requireLight("color");
    }
  }

  /**
   * A rectangle that shines with radiance {@code color} to the side from which its edges turn
   * counter-clockwise, where {@code edge1 × edge2} points; from behind it is not there.
   */
  record Rectangle(Vector3d corner, Vector3d edge1, Vector3d edge2, Rgb color) implements Light {

    /** The cosine of the edges' angle may be this much off. */
    private static final double SQUARE = 1e-6;

    /** Checks that it is a rectangle, and its colour. */
    public Rectangle {
      Check.finite("corner", corner);
      Check.direction("edge1", edge1);
      Check.direction("edge2", edge2);
      Check.positive("edge1", edge1.length());
      Check.positive("edge2", edge2.length());
      if (!(Math.abs(edge1.normalized().dot(edge2.normalized())) <= SQUARE)) {
        throw new BadValueException("edge2", "must be at a right angle to edge1");
      }
      color.requireLight("color");
    }
  }

  /**
   * Light from one point within a cone around the line to {@code lookAt}.
   *
   * @param angle the full opening angle in degrees, more than 0 and at most 180
   * @param softness the share, 0 to 1, of the half angle over which the light fades to zero at the
   *     rim
   */
  record Spot(Vector3d position, Vector3d lookAt, Rgb color, double angle, double softness)
      implements Light {
    /** Checks positions, colour, angle and softness. */
    public Spot {
      Check.finite("position", position);
      Check.finite("look_at", lookAt);
      color.requireLight("color");
      if (position.minus(lookAt).maxAbs() == 0) {
        throw new BadValueException("look_at", "must differ from position: " + position);
      }
      if (!(angle > 0 && angle <= 180)) {
        throw new BadValueException(
            "angle", "must be more than 0 and at most 180 degrees, but is " + angle);
      }
      Check.range("softness", softness, 0, 1);
    }
  }
}

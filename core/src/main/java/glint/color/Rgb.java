package glint.color;

import glint.math.BadValueException;

/** A linear RGB colour or radiance; immutable. Components are unbounded; 1 is display white. */
public record Rgb(double r, double g, double b) {

  /** No light. */
  public static final Rgb BLACK = new Rgb(0, 0, 0);

  /** Display white. */
  public static final Rgb WHITE = new Rgb(1, 1, 1);

  /** Returns the grey with all three components {@code v}. */
  public static Rgb grey(double v) {
    return new Rgb(v, v, v);
  }

  /** Returns {@code this + c}. */
  public Rgb plus(Rgb c) {
    return new Rgb(r + c.r, g + c.g, b + c.b);
  }

  /** Returns the component-wise product with {@code c}. */
  public Rgb times(Rgb c) {
    return new Rgb(r * c.r, g * c.g, b * c.b);
  }

  /** Returns this colour times {@code s}. */
  public Rgb times(double s) {
    return new Rgb(r * s, g * s, b * s);
  }

  /** Returns the largest component. */
  public double max() {
    return Math.max(r, Math.max(g, b));
  }

  /** Returns whether all components are exactly zero. */
  public boolean isBlack() {
    return r == 0 && g == 0 && b == 0;
  }

  /**
   * Checks a colour that a person wrote.
   *
   * @throws BadValueException unless all components are finite and at least zero
   */
  public void requireLight(String field) {
    if (!(r >= 0 && g >= 0 && b >= 0 && max() < Double.POSITIVE_INFINITY)) {
      throw new BadValueException(field, "must not be negative, infinite or NaN, but is " + this);
    }
  }

  /** Returns {@code "(r, g, b)"}. */
  @Override
  public String toString() {
    return "(" + r + ", " + g + ", " + b + ")";
  }
}

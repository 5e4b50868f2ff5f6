package glint.scene;

import glint.color.Rgb;

/**
 * The light of rays that meet nothing, blended from straight down to straight up; immutable.
 *
 * <p>For a unit direction d it is {@code lerp(down, up, (1 + d_y) / 2)}.
 */
public record Background(Rgb down, Rgb up) {

  /** No light. */
  public static final Background BLACK = constant(Rgb.BLACK);

  /** Checks that both colours are finite and not negative. */
  public Background {
    down.requireLight("down");
    up.requireLight("up");
  }

  /** Returns the same colour in every direction. */
  public static Background constant(Rgb color) {
    return new Background(color, color);
  }

  /** Returns whether the direction matters. */
  public boolean isConstant() {
    return down.equals(up);
  }
}

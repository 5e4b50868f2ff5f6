package glint.optics;

import glint.color.Rgb;

/** What multiplies the colour of a material, from place to place; immutable. */
public sealed interface Texture permits Pattern, ImageTexture {

  /** Returns the most that any point has, channel by channel. */
  Rgb most();
}

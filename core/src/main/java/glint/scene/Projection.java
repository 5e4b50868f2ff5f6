package glint.scene;

/** How places in the picture become rays. */
public sealed interface Projection permits Perspective, Orthographic {

  /** Returns a vertical angle of view with square pixels. */
  static Projection vertical(double degrees) {
    return new Perspective(degrees, false, 0);
  }

  /** Returns half the height of the picture plane, for an image of {@code width × height}. */
  double halfHeight(int width, int height);

  /** Returns half the width of the picture plane, for an image of {@code width × height}. */
  double halfWidth(int width, int height);
}

package glint.render;

/** An extra picture: of what the ray through each pixel's centre sees first, or of the render. */
public enum Aov {
  /** The distance from the eye along the ray, in scene units; infinite where nothing is seen. */
  DEPTH,
  /** The unit normal in world space, facing the eye; zero where nothing is seen. */
  NORMAL,
  /** The material's diffuse colour; black where nothing is seen. */
  ALBEDO,
  /** The number of the surface in scene order, from 0; -1 where nothing is seen. */
  ID,
  /** The camera rays that the pixel took. */
  SAMPLES,
  /** The estimate of the pixel's RMS error, in display levels. */
  ERROR;

  /** Returns whether it is of the scene, not of the render. */
  boolean isOfScene() {
    return this != SAMPLES && this != ERROR;
  }
}

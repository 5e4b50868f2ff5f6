package glint.light;

import glint.geometry.Hit;
import glint.geometry.Surface;
import glint.sampling.SobolSampler;

/** A light with an area, of radiance 1: the points of it that samples take. */
sealed interface Lamp permits BallLamp, PanelLamp {

  /**
   * Takes a point of the lamp as seen from a hit, and sets what it sends there, shadows aside: a
   * sample's direction, place and strength, such that the mean of strength times anything is the
   * integral of that over the lamp's solid angle, divided by π.
   *
   * <p>A centred sample is the middle of the lamp.
   *
   * @param numbers has drawn the pair that chooses the point
   * @return the strength; 0 if nothing of the lamp is above the surface, or seen from its front
   */
  double sample(Hit hit, SobolSampler numbers, LightSample out);

  /** Returns what rays meet; they see its outside only. */
  Surface shape();
}

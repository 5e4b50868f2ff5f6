package glint.trace;

import glint.geometry.Hit;
import glint.optics.Medium;
import glint.scene.Prepared;
import java.util.Arrays;

/**
 * The media that a ray is inside of, one entry for every boundary it has crossed into and not out
 * of; scratch.
 *
 * <p>Where several overlap, the one of the highest priority is there, of equal ones the one entered
 * last (Schmidt and Budge 2002). Media are known by their numbers in {@link Prepared}; surfaces of
 * equal media merge into one body.
 */
final class Interior {

  private final Prepared scene;
  private int[] media = new int[8];
  private int count;

  Interior(Prepared scene) {
    this.scene = scene;
  }

  /** Empties it: outside of everything. */
  void clear() {
    count = 0;
  }

  /** Makes this a copy of another. */
  void copy(Interior other) {
    if (media.length < other.count) {
      media = new int[other.media.length];
    }
    count = other.count;
    for (int i = 0; i < count; i++) { // they are too few for a call
      media[i] = other.media[i];
    }
  }

  /** Goes into a medium. */
  void enter(int medium) {
    if (count == media.length) {
      media = Arrays.copyOf(media, 2 * count);
    }
    media[count++] = medium;
  }

  /** Goes out of a medium; one that was never entered changes nothing. */
  void leave(int medium) {
    for (int i = count - 1; i >= 0; i--) {
      if (media[i] == medium) {
        count--;
        for (int j = i; j < count; j++) {
          media[j] = media[j + 1];
        }
        return;
      }
    }
  }

  /** Enters what a hit leaves, if it was never entered: who comes from behind comes from inside. */
  void complete(Hit hit) {
    int medium = scene.mediumOf(hit.surface);
    if (hit.crossing < 0 && medium != Prepared.OUTSIDE && !contains(medium)) {
      enter(medium);
    }
  }

  private boolean contains(int medium) {
    for (int i = 0; i < count; i++) {
      if (media[i] == medium) {
        return true;
      }
    }
    return false;
  }

  /** Returns the medium that is there, or {@link Prepared#OUTSIDE}. */
  int current() {
    if (count == 0) {
      return Prepared.OUTSIDE;
    }
    int best = media[0];
    for (int i = 1; i < count; i++) {
      if (priority(media[i]) >= priority(best)) {
        best = media[i];
      }
    }
    return best;
  }

  private int priority(int medium) {
    Medium m = scene.medium(medium);
    return m.priority();
  }
}

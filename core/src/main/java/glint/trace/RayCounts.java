package glint.trace;

/** How many rays of each kind were traced; scratch, owned by one worker and summed at the end. */
public final class RayCounts {

  public long camera;
  public long reflection;
  public long refraction;
  public long shadow;

  /** How often a highlight was evaluated. */
  public long highlights;

  /** The most successive bounces of any ray. */
  public int maxDepth;

  /** Adds another worker's counts. */
  public void add(RayCounts other) {
    camera += other.camera;
    reflection += other.reflection;
    refraction += other.refraction;
    shadow += other.shadow;
    highlights += other.highlights;
    maxDepth = Math.max(maxDepth, other.maxDepth);
  }

  /** Returns the number of rays of all kinds. */
  public long total() {
    return camera + reflection + refraction + shadow;
  }
}

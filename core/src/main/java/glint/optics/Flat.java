package glint.optics;

/**
 * An image of one by one scene units again and again, along the two axes other than that nearest to
 * the normal, upright as seen from where these point; immutable.
 */
public record Flat() implements Mapping {

  @Override
  public void find(double x, double y, double z, int flat, Texel texel) {
    texel.u = flat == 0 ? -z : x;
    texel.v = flat == 1 ? -z : y;
  }
}

package glint.io;

/**
 * An image that a material of an MTL file names, and how it is laid on; immutable.
 *
 * @param file as it is written, backslashes being slashes
 * @param line where it stands, from 1
 * @param column from 1
 * @param offsetU {@code -o}: added to u after the scale
 * @param scaleU {@code -s}: what u is multiplied by
 * @param clamp {@code -clamp on}: not repeated
 * @param base {@code -mm}: added to the image's values after the gain
 * @param gain {@code -mm}: what they are multiplied by
 */
public record MtlMap(
    String file,
    int line,
    int column,
    double offsetU,
    double offsetV,
    double scaleU,
    double scaleV,
    boolean clamp,
    double base,
    double gain) {}

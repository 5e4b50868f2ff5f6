package glint.geometry;

/**
 * A shape as a person writes it, in its own object space; immutable.
 *
 * <p>Every kind is a closed set: a ray through an edge or a tangent ray hits. Constructors reject
 * what has no shape with a {@link glint.math.BadValueException} that names the field.
 */
public sealed interface Surface
    permits Sphere, Triangle, Plane, Quad, Box, Pyramid, Cylinder, Mesh {}

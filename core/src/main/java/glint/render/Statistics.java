package glint.render;

import glint.trace.RayCounts;

/**
 * What a finished render reports of itself; immutable but for the counts, which nobody changes.
 *
 * @param rays rays traced, by kind, and the bounces reached
 * @param minSamples the fewest samples of a pixel
 * @param meanSamples the samples of a pixel, on average
 * @param maxSamples the most samples of a pixel
 * @param primitives how many things a ray can hit
 * @param geometryBytes what the primitives and the tree take in memory
 * @param invalid samples that were NaN or infinite; they are left out of their pixel's mean
 * @param invalidPixel the number, in row order, of the first pixel that has such a sample, if any
 * @param clipped pixels with a channel above display white
 * @param samplingError the estimate of the image's RMS error by sampling, in display levels
 * @param truncation a bound on the image's RMS error by bounces not followed, in display levels
 * @param renderSeconds wall time of tracing alone
 */
public record Statistics(
    RayCounts rays,
    int minSamples,
    double meanSamples,
    int maxSamples,
    int primitives,
    long geometryBytes,
    long invalid,
    int invalidPixel,
    long clipped,
    double samplingError,
    double truncation,
    double renderSeconds) {}

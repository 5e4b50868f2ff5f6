package glint.render;

import glint.trace.RayCounts;

/**
 * What tracing an image has come to, apart from the image; immutable but for the arrays.
 *
 * @param invalid samples that were NaN or infinite
 * @param invalidPixel the first pixel with such a sample, if any
 * @param cut for every pixel a bound on the radiance that was not followed, any channel
 * @param samplingError the estimate of the error by sampling, in levels
 */
record Traced(
    RayCounts rays,
    int minSamples,
    double meanSamples,
    int maxSamples,
    long invalid,
    int invalidPixel,
    double[] cut,
    double samplingError) {}

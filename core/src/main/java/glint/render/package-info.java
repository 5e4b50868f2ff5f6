/**
 * Pixels in parallel: from a prepared scene to an image, its statistics, and an estimate of its
 * error; of as many samples for every pixel, or to an error that is accepted.
 */
package glint.render;

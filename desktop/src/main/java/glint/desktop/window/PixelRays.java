package glint.desktop.window;

import glint.render.Replay;
import glint.scene.Prepared;
import java.awt.Point;

/**
 * The rays of a pixel's middle, as {@code glint replay --samples 1} tells of them; immutable.
 *
 * @param scene the picture that they belong to
 */
record PixelRays(Prepared scene, Point pixel, Replay.Sample sample) {}

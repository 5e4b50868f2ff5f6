/**
 * The window: a list of scenes, the picture of one as it is rendered, and what is known of it.
 *
 * <p>It knows nothing of rendering but to start and stop it, and its event thread does no work.
 */
package glint.desktop.window;

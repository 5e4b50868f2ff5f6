/**
 * The {@code glint} command: reads scene files, renders them in a batch, compares images.
 *
 * <p>Reading order: Main, RenderCommand, Batch, SceneRun; the rest serves these.
 */
package glint.desktop;

package glint.scene;

/**
 * Whether the renderer uses a feature for a scene, and why.
 *
 * @param feature what is used or left out, in the field's words
 * @param used whether its code runs
 * @param reason what in the scene decides it
 */
public record Decision(String feature, boolean used, String reason) {}

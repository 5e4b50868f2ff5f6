package glint.render;

import glint.image.Image;
import java.util.Map;

/** A finished picture, the extra pictures that were asked for, and the run's figures. */
public record RenderResult(Image image, Map<Aov, Image> aovs, Statistics statistics) {}

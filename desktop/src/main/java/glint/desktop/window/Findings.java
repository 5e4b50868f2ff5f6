package glint.desktop.window;

import glint.image.Image;
import glint.render.Aov;
import glint.render.Statistics;
import glint.scene.Prepared;
import java.util.Map;
import java.util.Optional;

/**
 * What a render knows beside its picture; immutable but for the maps, which change with it.
 *
 * @param prepared what is rendered
 * @param maps the estimated error and the samples of every pixel
 * @param statistics of the whole render; absent before its end
 */
record Findings(Prepared prepared, Map<Aov, Image> maps, Optional<Statistics> statistics) {}

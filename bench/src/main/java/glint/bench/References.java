package glint.bench;

import glint.image.Image;
import glint.io.Pfm;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.report.LongRun;
import glint.report.Reference;
import glint.scene.Prepared;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * References that were found before, kept in a folder.
 *
 * <p>Their names hold the hash of an image of one sample per pixel: where that is another one, so
 * is the scene or the model, and the reference is found anew.
 */
final class References {

  /** How many digits of a hash are enough to tell images apart. */
  private static final int DIGITS = 12;

  private final Path folder;

  References(Path folder) throws IOException {
    this.folder = Files.createDirectories(folder);
  }

  /** Returns the reference of a scene in the size of the settings. */
  Reference of(Prepared scene, RenderSettings settings) throws IOException {
    String key = key(scene, settings);
    Path picture = folder.resolve(key + ".pfm");
    Path uncertainty = folder.resolve(key + ".txt");
    if (Files.exists(uncertainty)) {
      try (InputStream in = new BufferedInputStream(Files.newInputStream(picture))) {
        Image image = Pfm.read(in, picture.toString());
        double levels = Double.parseDouble(Files.readString(uncertainty).trim());
        return new Reference(image, LongRun.ORIGIN, levels, scene.scene().transfer());
      }
    }
    Reference found = LongRun.of(scene, settings, () -> false);
    try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(picture))) {
      Pfm.write(found.image(), out);
    }
    Files.writeString(uncertainty, found.uncertainty() + "\n");
    return found;
  }

  /** Returns what a picture of a scene is called. */
  static String key(Prepared scene, RenderSettings settings) {
    RenderSettings single = settings.sampled(1, 0);
    String hash = new Renderer(scene, single).render(Progress.NONE).image().sha256();
    return String.format(
        "%s-%dx%d-%s",
        scene.scene().name(), settings.width(), settings.height(), hash.substring(0, DIGITS));
  }
}

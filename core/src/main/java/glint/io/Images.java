package glint.io;

import glint.image.ByteImage;
import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** The images that one scene file and its models name, each decoded once, at its first use. */
final class Images {

  /** What stands in for an image that cannot be read: a colour that no one overlooks. */
  static final ByteImage LOST = ByteImage.of(255, 0, 255);

  private final SceneFolder folder;

  /** By path. */
  private final Map<String, ByteImage> read = new HashMap<>();

  Images(SceneFolder folder) {
    this.folder = folder;
  }

  /**
   * Returns an image, or what stands in for it.
   *
   * @param paths where it is looked for, from the scene file's folder
   * @param written what messages call it
   * @param notes is told at the first use what is left aside
   */
  ByteImage find(List<String> paths, String written, Consumer<String> notes) {
    ByteImage image = read.get(paths.get(0));
    if (image == null) {
      image = read(paths, "image " + SourceText.quote(written) + " ", notes);
      read.put(paths.get(0), image);
    }
    return image;
  }

  private ByteImage read(List<String> paths, String name, Consumer<String> notes) {
    String reason = null;
    for (String path : paths) {
      try (InputStream in = folder.open(path)) {
        ByteImage image = folder.decode(in, remark -> notes.accept(name + remark));
        if (reason != null) {
          notes.accept(name + reason + "; " + SourceText.quote(path) + " is taken instead");
        }
        return image;
      } catch (IOException e) {
        reason = reason == null ? "cannot be read: " + e.getMessage() : reason;
      }
    }
    notes.accept(name + reason + "; magenta stands in for it");
    return LOST;
  }
}

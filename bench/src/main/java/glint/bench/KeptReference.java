package glint.bench;

import glint.image.Image;
import glint.io.Pfm;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * References of peers, kept in a folder.
 *
 * <p>Their names hold the hash of a first image: where that is another one, so is the scene, and
 * the reference is found anew.
 */
final class KeptReference {

  private KeptReference() {}

  /** Returns the reference of a scene, of so many by so many rays in every pixel. */
  static Image of(Peer peer, String scene, int fine, Path folder) throws IOException {
    Image first = peer.render(peer.settings().get(0)).image();
    String hash = Integer.toHexString(Arrays.hashCode(first.rgb()));
    Path file = folder.resolve(scene + "-" + peer.name() + "-" + fine + "-" + hash + ".pfm");
    if (!Files.exists(file)) {
      Image found = peer.reference(fine);
      try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
        Pfm.write(found, out);
      }
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      return Pfm.read(in, file.toString());
    }
  }
}

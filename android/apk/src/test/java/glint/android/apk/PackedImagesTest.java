package glint.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;

/**
 * The images of the packed scenes leave decoders no choice: PNG without alpha and colour profile
 * (PNG specification, 11.2 and 11.3).
 */
class PackedImagesTest {

  private static final long SIGNATURE = 0x89504e470d0a1a0aL;

  /** Transparency, and the chunks by which a decoder may change colours. */
  private static final Set<String> CHOICES = Set.of("tRNS", "iCCP", "gAMA", "cHRM", "sBIT");

  /** The bit of a colour type that says that there is alpha. */
  private static final int ALPHA = 4;

  @Test
  void areDecodedAlikeEverywhere() throws IOException {
    try (ZipFile zip = new ZipFile(System.getProperty("glint.apk.release"))) {
      List<? extends ZipEntry> images =
          zip.stream()
              .filter(entry -> entry.getName().startsWith("assets/images/"))
              .collect(Collectors.toList());
      assertFalse(images.isEmpty());
      for (ZipEntry image : images) {
        try (InputStream in = zip.getInputStream(image)) {
          check(image.getName(), new DataInputStream(in));
        }
      }
    }
  }

  private static void check(String name, DataInputStream in) throws IOException {
    assertEquals(SIGNATURE, in.readLong(), name);
    String type;
    do {
      byte[] chunk = new byte[in.readInt() + 4];
      in.readFully(chunk);
      in.readInt(); // the sum
      type = new String(chunk, 0, 4, StandardCharsets.US_ASCII);
      assertFalse(CHOICES.contains(type), name + " has a chunk " + type);
      if (type.equals("IHDR")) {
        assertEquals(8, chunk[4 + 8], name + ": bits of a channel");
        assertEquals(0, chunk[4 + 9] & ALPHA, name + ": colour type " + chunk[4 + 9]);
      }
    } while (!type.equals("IEND"));
    assertTrue(in.read() < 0, name + " goes on behind its end");
  }
}

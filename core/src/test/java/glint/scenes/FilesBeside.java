package glint.scenes;

import static org.junit.jupiter.api.Assertions.assertFalse;

import glint.image.ByteImage;
import glint.io.SceneFolder;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.imageio.ImageIO;

/**
 * What a scene file of this repository names. Its images are of codes that every platform decodes
 * alike: without alpha, and in sRGB.
 */
record FilesBeside(Path sceneFile) implements SceneFolder {

  @Override
  public InputStream open(String path) throws IOException {
    return Files.newInputStream(sceneFile.resolveSibling(path));
  }

  @Override
  public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
    BufferedImage image = ImageIO.read(in);
    assertFalse(image.getColorModel().hasAlpha());
    byte[] rgb = new byte[3 * image.getWidth() * image.getHeight()];
    for (int i = 0; i < rgb.length; i++) {
      int argb = image.getRGB(i / 3 % image.getWidth(), i / 3 / image.getWidth());
      rgb[i] = (byte) (argb >> 16 - 8 * (i % 3));
    }
    return new ByteImage(image.getWidth(), image.getHeight(), rgb);
  }
}

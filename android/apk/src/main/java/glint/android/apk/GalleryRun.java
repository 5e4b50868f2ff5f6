package glint.android.apk;

import com.sun.management.OperatingSystemMXBean;
import glint.image.ByteImage;
import glint.io.SceneFile;
import glint.io.SceneFiles;
import glint.io.SceneFolder;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import javax.imageio.ImageIO;

/**
 * Renders every scene of a file with whatever core is on the class path, and prints a line of each:
 * name, hash of the image, seconds of processor time.
 */
public final class GalleryRun {

  private GalleryRun() {}

  /**
   * Renders.
   *
   * @param args the file; columns and rows of the images; the error to render to; threads; how
   *     often, of which the last is timed
   */
  public static void main(String[] args) throws IOException {
    Path file = Path.of(args[0]);
    RenderSettings settings =
        new RenderSettings(
            Integer.parseInt(args[1]),
            Integer.parseInt(args[2]),
            new Goal.Error(Double.parseDouble(args[3])),
            0,
            OptionalInt.empty(),
            Integer.parseInt(args[4]),
            32,
            Set.of());
    OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    int times = Integer.parseInt(args[5]);
    try (InputStream in = Files.newInputStream(file)) {
      SceneFile scenes = SceneFiles.read(in, file.getFileName().toString(), new Folder(file));
      for (Scene scene : scenes.scenes()) {
        Prepared prepared = Prepared.of(scene);
        for (int i = 1; i < times; i++) {
          RenderResult unused = new Renderer(prepared, settings).render(Progress.NONE);
        }
        long began = system.getProcessCpuTime();
        RenderResult result = new Renderer(prepared, settings).render(Progress.NONE);
        double seconds = (system.getProcessCpuTime() - began) * 1e-9;
        System.out.printf(
            Locale.ROOT, "%s %s %.3f%n", scene.name(), result.image().sha256(), seconds);
      }
    }
  }

  /** The folder of a scene file; images are decoded as on the desktop. */
  private record Folder(Path file) implements SceneFolder {
    @Override
    public InputStream open(String path) throws IOException {
      return Files.newInputStream(file.resolveSibling(path));
    }

    @Override
    public ByteImage decode(InputStream in, Consumer<String> remarks) throws IOException {
      BufferedImage image = ImageIO.read(in);
      int width = image.getWidth();
      int height = image.getHeight();
      byte[] rgb = new byte[3 * width * height];
      int at = 0;
      for (int argb : image.getRGB(0, 0, width, height, null, 0, width)) {
        rgb[at++] = (byte) (argb >> 16);
        rgb[at++] = (byte) (argb >> 8);
        rgb[at++] = (byte) argb;
      }
      return new ByteImage(width, height, rgb);
    }
  }
}

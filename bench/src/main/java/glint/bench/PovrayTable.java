package glint.bench;

import glint.color.Transfer;
import glint.image.Comparison;
import glint.image.Image;
import glint.render.RenderResult;
import glint.scene.Scene;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;

/**
 * Renders the scenes of bench/povray with Glint and with POV-Ray and compares the images; see
 * docs/bench-povray.md.
 *
 * <p>Where POV-Ray's laws are other than Glint's, its scenes can be told Glint's (their variable
 * {@code Law}). The pixels that change with it are left out of one figure; with Glint's laws no
 * pixel is.
 */
public final class PovrayTable {

  /** The most that the models may differ where they agree, in display levels. */
  private static final double BOUND = 0.5;

  /** By how much the difference is brighter in the sheets of images. */
  private static final double MAGNIFIED = 20;

  private PovrayTable() {}

  /**
   * Prints the table; exits with 1 if POV-Ray is missing or an image is too far off.
   *
   * @param args the folder of the scenes, the folder for sheets of images, and the commit
   */
  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args[0]);
    Path out = Files.createDirectories(Path.of(args[1]));
    Povray povray = new Povray(folder, out.resolve("povray.log"));
    try {
      System.out.printf("%s against Glint: %s.%n%n", povray.version(), Machine.with(args[2]));
    } catch (IOException e) {
      System.err.println(e.getMessage());
      System.exit(1);
    }
    System.out.println(
        "| scene | as it is | other laws matter | where not | max there | with Glint's laws | max |"
            + " Glint left out |");
    System.out.println("|---|---|---|---|---|---|---|---|");
    boolean good = true;
    for (Scene scene : Scenes.read(folder.resolve("scenes.yaml"))) {
      good &= compare(scene, povray, out);
    }
    System.out.println("\nimages: " + out);
    System.exit(good ? 0 : 1);
  }

  private static boolean compare(Scene scene, Povray povray, Path out) throws IOException {
    RenderResult result = Scenes.render(scene);
    Image glint = result.image();
    Image theirs = povray.render(scene.name(), scene.width(), scene.height(), 0);
    Image ruled = povray.render(scene.name(), scene.width(), scene.height(), 1);

    // Set the pixels aside in which another law matters.
    int pixels = scene.width() * scene.height();
    int aside = 0;
    Image agreed = new Image(scene.width(), scene.height());
    System.arraycopy(glint.rgb(), 0, agreed.rgb(), 0, 3 * pixels);
    for (int i = 0; i < 3 * pixels; i += 3) {
      if (differ(theirs, ruled, i)) {
        System.arraycopy(theirs.rgb(), i, agreed.rgb(), i, 3);
        aside++;
      }
    }
    double share = (double) aside / pixels;
    Comparison all = Comparison.of(glint, theirs, Transfer.SRGB);
    Comparison where = Comparison.of(agreed, theirs, Transfer.SRGB);
    Comparison lawful = Comparison.of(glint, ruled, Transfer.SRGB);
    double rmseWhere = where.levelsRmse() / Math.sqrt(1 - share);
    System.out.printf(
        Locale.ROOT,
        "| %s | %.3f | %.1f %% | %.3f | %.1f | %.3f | %.1f | %.3f |%n",
        scene.name(),
        all.levelsRmse(),
        100 * share,
        rmseWhere,
        where.levelsMax(),
        lawful.levelsRmse(),
        lawful.levelsMax(),
        result.statistics().truncation());
    File sheet = out.resolve(scene.name() + ".png").toFile();
    ImageIO.write(sheet(glint, theirs, ruled), "png", sheet);
    return rmseWhere <= BOUND && lawful.levelsRmse() <= BOUND;
  }

  private static boolean differ(Image a, Image b, int at) {
    return a.rgb()[at] != b.rgb()[at]
        || a.rgb()[at + 1] != b.rgb()[at + 1]
        || a.rgb()[at + 2] != b.rgb()[at + 2];
  }

  /** Glint and POV-Ray; the differences from POV-Ray as it is, and with Glint's laws. */
  private static BufferedImage sheet(Image glint, Image theirs, Image ruled) {
    int width = glint.width();
    int height = glint.height();
    BufferedImage sheet = new BufferedImage(2 * width, 2 * height, BufferedImage.TYPE_INT_RGB);
    put(sheet, 0, 0, glint);
    put(sheet, width, 0, theirs);
    put(sheet, 0, height, difference(glint, theirs));
    put(sheet, width, height, difference(glint, ruled));
    return sheet;
  }

  private static void put(BufferedImage sheet, int x, int y, Image image) {
    int[] argb = image.toArgb(Transfer.SRGB);
    sheet.setRGB(x, y, image.width(), image.height(), argb, 0, image.width());
  }

  /** Returns a picture of an image. */
  static BufferedImage picture(Image image) {
    BufferedImage picture =
        new BufferedImage(image.width(), image.height(), BufferedImage.TYPE_INT_RGB);
    put(picture, 0, 0, image);
    return picture;
  }

  /** The absolute difference in levels, magnified, as a picture. */
  private static Image difference(Image a, Image b) {
    Image out = new Image(a.width(), a.height());
    for (int i = 0; i < out.rgb().length; i++) {
      double levels = Transfer.SRGB.level(a.rgb()[i]) - Transfer.SRGB.level(b.rgb()[i]);
      out.rgb()[i] = Transfer.SRGB.decode(Math.min(1, MAGNIFIED * Math.abs(levels) / 255));
    }
    return out;
  }
}

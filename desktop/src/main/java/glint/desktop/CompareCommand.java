package glint.desktop;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import glint.color.Transfer;
import glint.image.Comparison;
import glint.image.Image;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint compare}: how far an image is from a reference. */
@Command(
    name = "compare",
    description = "Prints the error of an image against a reference; PNG or PFM, of one size.",
    mixinStandardHelpOptions = true)
final class CompareCommand implements Callable<Integer> {

  private static final Gson GSON = new GsonBuilder().serializeNulls().create();

  @Spec private CommandSpec spec;

  @Parameters(index = "0", paramLabel = "A", description = "An image.")
  private Path image;

  @Parameters(index = "1", paramLabel = "B", description = "The reference.")
  private Path reference;

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  private Transfer transfer = Transfer.SRGB;

  @Option(
      names = "--transfer",
      paramLabel = "CURVE",
      description = "How PNG codes were made: srgb (default) or linear.")
  void transfer(String name) {
    transfer = Words.pick(spec, "--transfer", name, Transfer.class);
  }

  @Override
  public Integer call() throws RunException {
    Image a = ImageFiles.read(image, transfer);
    Image b = ImageFiles.read(reference, transfer);
    if (a.width() != b.width() || a.height() != b.height()) {
      throw new RunException(
          image + " has " + size(a) + " pixels, but " + reference + " has " + size(b));
    }
    Comparison comparison = Comparison.of(a, b, transfer);
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(GSON.toJson(ComparisonJson.of(comparison)));
    } else {
      print(comparison, out);
    }
    return ExitCode.DONE;
  }

  private static void print(Comparison c, PrintWriter out) {
    Table table = new Table("rmse", number(c.rmse()), "linear");
    table.row("max", number(c.max()), "linear");
    table.row("mae", number(c.mae()), "linear");
    table.row("mrse", number(c.mrse()), "relative, linear");
    table.row("rmse", number(c.levelsRmse()), "display levels of 255");
    table.row("max", number(c.levelsMax()), "display levels of 255");
    table.row("psnr", c.psnr().isPresent() ? number(c.psnr().getAsDouble()) : "-", "dB");
    table.row("ssim", number(c.ssim()), "1 = equal");
    table.row("flip mean", number(c.flipMean()), "0 = equal");
    table.row("flip p99", number(c.flipP99()), "99th percentile");
    table.row("invalid", String.valueOf(c.invalid()), "pixels that are NaN or infinite");
    out.println(c.width() + "x" + c.height() + " pixels");
    table.print(out);
    if (c.max() > 0) {
      Comparison.PixelError worst = c.worst().get(0);
      out.println("worst pixel: " + worst.x() + "," + worst.y());
    }
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.6g", value);
  }

  private static String size(Image image) {
    return image.width() + "x" + image.height();
  }
}

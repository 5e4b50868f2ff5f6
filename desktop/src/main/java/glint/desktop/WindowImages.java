package glint.desktop;

import glint.color.Transfer;
import glint.desktop.window.ImageStore;
import glint.desktop.window.Picked;
import glint.image.Image;
import glint.io.Pfm;
import glint.render.RenderSettings;
import glint.render.Statistics;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Writes images as {@code glint render} does, byte for byte, and reads those to compare with. */
final class WindowImages implements ImageStore {

  @Override
  public void write(Picked picked, Image image, Optional<Statistics> statistics, Path file)
      throws IOException {
    try {
      if (file.toString().toLowerCase(Locale.ROOT).endsWith(".pfm")) {
        AtomicFile.write(file, path -> writePfm(image, path));
      } else {
        String record = statistics.map(all -> record(picked, image, all)).orElse("unfinished");
        Transfer transfer = picked.scene().transfer();
        AtomicFile.write(file, path -> PngFile.write(image, transfer, record, path));
      }
    } catch (IOException e) {
      throw new IOException(Reasons.of(file, e), e);
    }
  }

  @Override
  public Image read(Path file, Transfer transfer) throws IOException {
    try {
      return ImageFiles.read(file, transfer);
    } catch (RunException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static void writePfm(Image image, Path path) throws IOException {
    try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(path), 1 << 16)) {
      Pfm.write(image, out);
    }
  }

  /** Returns what vouches for an image of a whole render with the default options. */
  private static String record(Picked picked, Image image, Statistics statistics) {
    RenderSettings settings = RenderSettings.of(picked.scene());
    FileTime unknown = FileTime.fromMillis(0);
    Job job = new Job(picked.file(), unknown, picked.digest(), 0, picked.scene());
    SceneStats.Seconds seconds = new SceneStats.Seconds(0, 0, statistics.renderSeconds(), 0);
    SceneStats stats = SceneStats.of(picked.scene().name(), settings, seconds, statistics, image);
    String fingerprint = RunRecord.fingerprint(job, settings, RenderOptions.Format.PNG);
    return new RunRecord(fingerprint, Map.of(), stats).toJson();
  }
}

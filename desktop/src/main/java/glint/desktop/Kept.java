package glint.desktop;

import glint.image.Image;
import glint.io.Pfm;
import glint.render.RenderSettings;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Decides which scenes an earlier run has finished. */
final class Kept {

  private Kept() {}

  /**
   * Returns the statistics of a scene if all files that this run would write for it are there.
   *
   * <p>A PNG carries a record, and must carry the one of this run. PFM files alone carry none: they
   * must be whole, of the right size and newer than the scene file and its models.
   */
  static Optional<SceneStats> find(
      Job job, RenderSettings settings, OutputFiles files, RenderOptions.Format format) {
    try {
      if (files.png().isPresent()) {
        String fingerprint = RunRecord.fingerprint(job, settings, format);
        return recorded(files.png().get(), fingerprint, files).map(r -> r.scene().kept());
      }
      for (Path pfm : files.pfms()) {
        if (!isWhole(pfm, job, settings)) {
          return Optional.empty();
        }
      }
      return Optional.of(SceneStats.unrecorded(job.scene().name(), settings));
    } catch (IOException e) {
      // What cannot be read is rendered again.
      return Optional.empty();
    }
  }

  private static Optional<RunRecord> recorded(Path png, String fingerprint, OutputFiles files)
      throws IOException {
    Optional<RunRecord> record = PngInfo.read(png).record().flatMap(RunRecord::fromJson);
    if (record.isEmpty() || !record.get().fingerprint().equals(fingerprint)) {
      return Optional.empty();
    }
    for (Path pfm : files.pfms()) {
      String digest = record.get().files().get(pfm.getFileName().toString());
      if (!Digests.of(pfm).equals(digest)) {
        return Optional.empty();
      }
    }
    return record;
  }

  private static boolean isWhole(Path pfm, Job job, RenderSettings settings) throws IOException {
    if (Files.getLastModifiedTime(pfm).compareTo(job.modified()) <= 0) {
      return false;
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(pfm))) {
      Image image = Pfm.read(in, pfm.toString());
      return image.width() == settings.width() && image.height() == settings.height();
    }
  }
}

package glint.desktop;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import glint.render.RenderSettings;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What a PNG says of the run that made it; immutable, and the same for the same run.
 *
 * @param fingerprint hash of everything that decides the image
 * @param files SHA-256 of the other files of the scene, by name
 * @param scene the statistics; times are left out
 */
record RunRecord(String fingerprint, Map<String, String> files, SceneStats scene) {

  private static final Gson GSON =
      new GsonBuilder().serializeNulls().disableHtmlEscaping().create();

  /** What differs between runs that make the same image. */
  private static final List<String> VARYING = List.of("seconds", "raysPerSecond", "resumed");

  /** Sorts the files by name. */
  RunRecord {
    files = new TreeMap<>(files);
  }

  /**
   * Returns the hash of all that decides which files a run writes for a scene, and their bytes: the
   * scene file and its models, the scene's name, every option that changes an image, and the
   * version.
   */
  static String fingerprint(Job job, RenderSettings settings, RenderOptions.Format format) {
    String all =
        String.join(
            "\n",
            "glint " + Version.glint(),
            "file " + job.digest(),
            "scene " + job.scene().name(),
            "size " + settings.width() + "x" + settings.height(),
            "goal " + settings.goal(),
            "seed " + settings.seed(),
            "depth " + (settings.maxDepth().isPresent() ? settings.maxDepth().getAsInt() : "-"),
            "format " + format.name().toLowerCase(Locale.ROOT),
            "aov " + new TreeSet<>(settings.aovs()));
    return Digests.of(all);
  }

  /** Returns the record as JSON in ASCII, as PNG's text chunks need it. */
  String toJson() {
    JsonObject json = GSON.toJsonTree(this).getAsJsonObject();
    VARYING.forEach(json.getAsJsonObject("scene")::remove);
    StringBuilder ascii = new StringBuilder();
    for (char c : GSON.toJson(json).toCharArray()) {
      ascii.append(c < 128 ? String.valueOf(c) : String.format(Locale.ROOT, "\\u%04x", (int) c));
    }
    return ascii.toString();
  }

  /** Returns the record that JSON holds, or nothing if it is not a whole one. */
  static Optional<RunRecord> fromJson(String json) {
    try {
      RunRecord r = GSON.fromJson(json, RunRecord.class);
      boolean whole =
          r != null && r.fingerprint != null && r.scene != null && r.scene.sha256() != null;
      return whole ? Optional.of(r) : Optional.empty();
    } catch (RuntimeException e) {
      // Gson fails in many ways; whatever it is, the text is not ours.
      return Optional.empty();
    }
  }
}

package glint.desktop;

import java.text.Normalizer;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;

/** Checks that nothing is written twice, not even where the file system ignores case. */
final class UniqueNames {

  private UniqueNames() {}

  /**
   * Checks some scenes.
   *
   * @param names what a scene becomes
   * @throws RunException if two scenes would become the same
   */
  static void check(List<Job> jobs, Function<Job, List<String>> names) throws RunException {
    Map<String, Job> writers = new HashMap<>();
    for (Job job : jobs) {
      for (String name : names.apply(job)) {
        String key = Normalizer.normalize(name, Normalizer.Form.NFC).toLowerCase(Locale.ROOT);
        Job other = writers.put(key, job);
        if (other != null) {
          throw new RunException(
              String.format(
                  Locale.ROOT,
                  "scene '%s' of %s and scene '%s' of %s would both become %s; rename one, or"
                      + " run them apart with --scene and --out",
                  other.scene().name(),
                  other.file(),
                  job.scene().name(),
                  job.file(),
                  name));
        }
      }
    }
  }
}

package glint.desktop;

import glint.io.Suggestion;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The choice of scenes. */
final class SceneFilter {

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "Only this scene; may be repeated (default: all).")
  private List<String> names = new ArrayList<>();

  /**
   * Returns the scenes that are asked for, and the frames of turntables, in the order of their
   * files.
   *
   * <p>A name that no scene has is wrong usage; but where a file has problems, it may be the name
   * of the scene that could not be read, and is only one more failure.
   */
  List<Job> select(Inputs inputs, Consumer<Failed> failures) {
    return select(command, names, inputs, failures);
  }

  /** Returns the scenes of these names, or all if there is none; see the other method. */
  static List<Job> select(
      CommandSpec command, List<String> names, Inputs inputs, Consumer<Failed> failures) {
    if (names.isEmpty()) {
      return inputs.jobs();
    }
    TreeSet<String> known = new TreeSet<>();
    inputs.jobs().forEach(job -> known.add(job.scene().name()));
    List<Job> chosen = inputs.jobs().stream().flatMap(job -> choose(job, names)).toList();
    for (String name : names) {
      if (chosen.stream().noneMatch(job -> job.scene().name().equals(name))) {
        String line = "no scene is called '" + name + "'" + Suggestion.hint(name, known);
        if (inputs.problems().isEmpty()) {
          throw Words.wrong(command, line + "\nThe scenes are: " + String.join(", ", known));
        }
        failures.accept(new Failed(name, line));
      }
    }
    return chosen;
  }

  /** Returns a scene that is named, or else those of its frames that are. */
  private static Stream<Job> choose(Job job, List<String> names) {
    return names.contains(job.scene().name())
        ? Stream.of(job)
        : job.pictures().stream().filter(picture -> names.contains(picture.scene().name()));
  }
}

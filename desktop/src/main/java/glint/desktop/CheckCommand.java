package glint.desktop;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint check}: reads and validates only. */
@Command(
    name = "check",
    description = "Reads scene files and prints whatever is wrong with them; renders nothing.",
    mixinStandardHelpOptions = true)
final class CheckCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Parameters(paramLabel = "FILE", arity = "1..*", description = "Scene files or models.")
  private List<Path> files;

  @Override
  public Integer call() {
    int exitCode = ExitCode.DONE;
    for (Path file : files) {
      if (!check(file)) {
        exitCode = ExitCode.FAILED;
      }
    }
    return exitCode;
  }

  private boolean check(Path file) {
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    Inputs inputs = Inputs.read(List.of(file), err);
    inputs.problems().forEach(problem -> err.println(problem.message()));
    inputs.notes().forEach(out::println);
    if (inputs.problems().isEmpty()) {
      out.println(file + ": " + Figures.count(inputs.jobs().size(), "scene") + ", no problems");
    }
    return inputs.problems().isEmpty();
  }
}

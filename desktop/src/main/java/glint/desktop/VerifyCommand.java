package glint.desktop;

import glint.verify.HardCase;
import glint.verify.HardCases;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint verify}: runs the numerical hard cases, or what scene files expect of pictures. */
@Command(
    name = "verify",
    description = {
      "Runs the numerical hard cases on this machine and prints one row for each; of scene files,"
          + " renders the scenes that say what their pictures must show (expect:), and prints one"
          + " row for each expectation."
    },
    mixinStandardHelpOptions = true)
final class VerifyCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Option(names = "--json", description = "Prints one JSON object instead of a table.")
  private boolean json;

  @Option(names = "--long", description = "Tries more of each hard case, which takes minutes.")
  private boolean effort;

  @Parameters(
      paramLabel = "FILE",
      arity = "0..*",
      description = "Scene files to verify in place of the hard cases.")
  private List<Path> files = new ArrayList<>();

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    if (!files.isEmpty()) {
      return new SceneVerification(out, spec.commandLine().getErr(), json).run(files);
    }
    List<HardCase> cases = HardCases.all();
    int width = cases.stream().mapToInt(each -> each.id().length()).max().orElse(0);
    CaseTable table = new CaseTable(out, json, width);
    for (HardCase each : cases) {
      table.add(each.run(effort ? HardCase.Effort.LONG : HardCase.Effort.SHORT));
    }
    return table.end() == 0 ? ExitCode.DONE : ExitCode.FAILED;
  }
}

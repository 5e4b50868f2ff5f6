package glint.desktop;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint report}: speed against error. */
@Command(
    name = "report",
    description = "Measures what an image of each scene costs and how far it is from the truth.",
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Writes speed-and-error.html, .md and .json and the charts of these into --out.",
      "Example: glint report scenes/gallery.yaml --size 160x120 --time-limit 2m"
    })
final class ReportCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Mixin private SceneFilter filter;

  @Mixin private ReportOptions options;

  @Parameters(paramLabel = "FILE", arity = "1..*", description = "Scene files or models.")
  private List<Path> files;

  @Override
  public Integer call() throws RunException {
    Reporter reporter = new Reporter(spec.commandLine().getErr(), options.quiet);
    try (Interrupt interrupt = Interrupt.install()) {
      String command = "glint " + String.join(" ", arguments());
      return new ReportRun(filter, options, reporter, interrupt).run(command, files);
    }
  }

  /** Returns all words behind {@code glint}. */
  private List<String> arguments() {
    return spec.commandLine().getParseResult().originalArgs();
  }
}

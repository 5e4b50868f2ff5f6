package glint.desktop;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint render}: one image per scene of each file. */
@Command(
    name = "render",
    description = "Renders every scene of each file, or those named, to one image per scene.",
    mixinStandardHelpOptions = true,
    footer = {
      "",
      "Exit codes: 0 done, 1 something failed, 2 wrong usage, 130 interrupted.",
      "Example: glint render scenes/gallery.yaml --size 1280x720 --stats out/stats.json"
    })
final class RenderCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Mixin private SceneFilter filter;

  @Mixin private RenderOptions options;

  @Parameters(paramLabel = "FILE", arity = "1..*", description = "Scene files or models.")
  private List<Path> files;

  @Override
  public Integer call() throws RunException {
    options.goal(); // complains before anything is read
    Reporter reporter = new Reporter(spec.commandLine().getErr(), options.quiet);
    try (Interrupt interrupt = Interrupt.install()) {
      return new Batch(filter, options, reporter, interrupt).run(files);
    }
  }
}

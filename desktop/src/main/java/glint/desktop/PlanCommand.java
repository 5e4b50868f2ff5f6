package glint.desktop;

import glint.scene.Decision;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint plan}: what each scene needs, and what is therefore left out. */
@Command(
    name = "plan",
    description = "Prints what each scene needs and what is therefore left out; renders nothing.",
    mixinStandardHelpOptions = true)
final class PlanCommand implements Callable<Integer> {

  @Spec private CommandSpec spec;

  @Mixin private SceneFilter filter;

  @Parameters(paramLabel = "FILE", description = "A scene file or a model.")
  private Path file;

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    Inputs inputs = Inputs.read(List.of(file), err);
    List<Failed> failed = new ArrayList<>(inputs.problems());
    List<Job> jobs = filter.select(inputs, failed::add);
    failed.forEach(problem -> err.println(problem.message()));
    for (Job job : jobs) {
      print(job.scene(), out);
    }
    return failed.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static void print(Scene scene, PrintWriter out) {
    Prepared prepared = Prepared.of(scene);
    Table table = new Table("feature", "used", "because");
    for (Decision decision : prepared.plan().decisions()) {
      table.row(decision.feature(), decision.used() ? "yes" : "no", decision.reason());
    }
    String primitives = Figures.count(prepared.primitiveCount(), "primitive");
    String size = scene.width() + "x" + scene.height();
    String frames =
        scene.turntable().map(t -> Figures.count(t.frames(), "frame") + ", ").orElse("");
    out.println(scene.name() + ": " + size + ", " + frames + primitives);
    table.print(out);
    out.println();
  }
}

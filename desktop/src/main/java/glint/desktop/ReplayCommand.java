package glint.desktop;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.math.BadValueException;
import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.RayTree;
import glint.trace.RayTreeText;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code glint replay}: one pixel, and the tree of rays that it comes from. */
@Command(
    name = "replay",
    description =
        "Traces one pixel as 'glint render' does with the same options, and prints the tree of its"
            + " rays with every hit and weight.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: glint replay scenes/gallery.yaml --scene transparency --pixel 400,240"})
final class ReplayCommand implements Callable<Integer> {

  /** So many samples have a line each; of more, these are the ones farthest from the mean. */
  private static final int LISTED = 16;

  @Spec private CommandSpec spec;

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "The scene; may be left out where the file has only one.")
  private String name;

  @Mixin private ReplayOptions options;

  @Parameters(paramLabel = "FILE", description = "A scene file or a model.")
  private Path file;

  @Option(
      names = "--sample",
      paramLabel = "K",
      description =
          "Only this sample, from 0 (default: a line for each, and the one that differs most).")
  private Integer sample;

  private int[] pixel;

  @Option(
      names = "--pixel",
      required = true,
      paramLabel = "X,Y",
      description = "Column from the left and row from the top, from 0.")
  void pixel(String text) {
    if (!text.matches("[0-9]{1,9},[0-9]{1,9}")) {
      throw Words.wrong(spec, "--pixel must be column,row, such as 320,240, but is '" + text + "'");
    }
    pixel = Arrays.stream(text.split(",")).mapToInt(Integer::parseInt).toArray();
  }

  @Override
  public Integer call() {
    PrintWriter err = spec.commandLine().getErr();
    Inputs inputs = Inputs.read(List.of(file), err);
    List<Failed> failed = new ArrayList<>(inputs.problems());
    List<String> names = name == null ? List.of() : List.of(name);
    List<Job> jobs = SceneFilter.select(spec, names, inputs, failed::add);
    failed.forEach(problem -> err.println(problem.message()));
    if (jobs.size() > 1) {
      String known = jobs.stream().map(j -> j.scene().name()).collect(Collectors.joining(", "));
      throw Words.wrong(spec, "--scene must name one of the scenes: " + known);
    }
    if (!jobs.isEmpty()) {
      replay(jobs.get(0).scene());
    }
    return failed.isEmpty() ? ExitCode.DONE : ExitCode.FAILED;
  }

  private void replay(Scene scene) {
    RenderSettings settings = options.settings(scene);
    int samples = settings.samples();
    int only = sample == null ? 0 : Words.inRange(spec, "--sample", sample, 0, samples - 1);
    Prepared prepared = Prepared.of(scene);
    Replay replay;
    try {
      replay = new Replay(prepared, settings, pixel[0], pixel[1]);
    } catch (BadValueException e) {
      throw Words.wrong(spec, "--" + e.getMessage());
    }
    PrintWriter out = spec.commandLine().getOut();
    printValue(scene, settings, replay, out);
    boolean choose = sample == null && samples > 1;
    Replay.Sample shown = choose ? printSamples(replay, samples, out) : replay.sample(only);
    String choice = choose ? ", the farthest from the mean; --sample K shows another" : "";
    out.printf(
        Locale.ROOT,
        "%nsample %d, at %.4f, %.4f in the pixel%s%n",
        shown.number(),
        shown.x(),
        shown.y(),
        choice);
    RayTreeText.of(prepared, shown.tree()).forEach(out::println);
  }

  private void printValue(Scene scene, RenderSettings settings, Replay replay, PrintWriter out) {
    Rgb value = replay.value();
    String place = "pixel " + pixel[0] + "," + pixel[1];
    String size = settings.width() + "x" + settings.height();
    out.println(scene.name() + ": " + place + " of " + size);
    Transfer codes = scene.transfer();
    String code =
        codes.code(value.r()) + ", " + codes.code(value.g()) + ", " + codes.code(value.b());
    String count = Figures.count(settings.samples(), "sample");
    out.println("mean of " + count + " " + value + ", as PNG " + code);
    if (replay.invalid() > 0) {
      out.println(Figures.count(replay.invalid(), "sample") + " not finite and left out");
    }
  }

  /** Prints a line for each sample, or for those that differ most; returns the one that does. */
  private static Replay.Sample printSamples(Replay replay, int samples, PrintWriter out) {
    List<Integer> farthest = replay.farthest(LISTED);
    out.println();
    if (samples > LISTED) {
      out.println("the " + LISTED + " samples that are farthest from the mean");
    }
    Table table = new Table("sample", "rays", "radiance");
    for (int number : farthest.stream().sorted().toList()) {
      RayTree tree = replay.sample(number).tree();
      String rays = Integer.toString(tree.rays().size());
      table.row(Integer.toString(number), rays, tree.radiance().toString());
    }
    table.print(out);
    return replay.sample(farthest.get(0));
  }
}

package glint.desktop;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.math.BadValueException;
import glint.render.Goal;
import glint.render.PixelHistory;
import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.RayTreeText;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
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
    Prepared prepared = Prepared.of(scene);
    try {
      if (settings.goal() instanceof Goal.Samples samples) {
        replaySamples(prepared, settings, samples.count());
      } else {
        replayRays(prepared, settings);
      }
    } catch (BadValueException e) {
      throw Words.wrong(spec, "--" + e.getMessage());
    }
  }

  private void replaySamples(Prepared scene, RenderSettings settings, int samples) {
    int only = sample == null ? 0 : Words.inRange(spec, "--sample", sample, 0, samples - 1);
    Replay replay = new Replay(scene, settings, pixel[0], pixel[1]);
    PrintWriter out = spec.commandLine().getOut();
    String count = Figures.count(samples, "sample");
    printValue(scene.scene(), settings, "mean of " + count + " " + replay.value(), replay.value());
    if (replay.invalid() > 0) {
      out.println(Figures.count(replay.invalid(), "sample") + " not finite and left out");
    }
    boolean choose = sample == null && samples > 1;
    List<Integer> far = choose ? replay.farthest(LISTED) : List.of(only);
    if (choose) {
      List<Replay.Sample> listed = far.stream().sorted().map(replay::sample).toList();
      printSamples(listed, samples, "sample", "mean");
    }
    printTree(scene, replay.sample(far.get(0)), "sample", choose ? "mean" : null);
  }

  private void replayRays(Prepared scene, RenderSettings settings) {
    PixelHistory history = PixelHistory.of(scene, settings, pixel[0], pixel[1]);
    List<Replay.Sample> rays = history.rays();
    String error = String.format(Locale.ROOT, "%.2g", history.error());
    String what = "value " + history.value() + ", claimed to within " + error + " levels";
    printValue(scene.scene(), settings, what, history.value());
    boolean choose = sample == null;
    List<Replay.Sample> far = farthest(history);
    if (choose) {
      List<Replay.Sample> listed = new ArrayList<>(far.subList(0, Math.min(LISTED, far.size())));
      listed.sort(Comparator.comparingInt(Replay.Sample::number));
      printSamples(listed, rays.size(), "camera ray", "value");
    }
    int number =
        choose ? 0 : Words.inRange(spec, "--sample", sample, 0, Math.max(0, rays.size() - 1));
    printTree(scene, choose ? far.get(0) : rays.get(number), "camera ray", choose ? "value" : null);
  }

  /** Returns all rays, those first that are farthest in any channel from the pixel's value. */
  private static List<Replay.Sample> farthest(PixelHistory history) {
    Rgb v = history.value();
    List<Replay.Sample> rays = new ArrayList<>(history.rays());
    Comparator<Replay.Sample> distance =
        Comparator.comparingDouble(
            each -> {
              Rgb r = each.tree().radiance();
              double red = Math.abs(r.r() - v.r());
              return Math.max(Math.max(red, Math.abs(r.g() - v.g())), Math.abs(r.b() - v.b()));
            });
    rays.sort(distance.reversed());
    return rays;
  }

  /** Prints a line for each; there may be more that are not listed. */
  private void printSamples(List<Replay.Sample> listed, int all, String kind, String centre) {
    PrintWriter out = spec.commandLine().getOut();
    out.println();
    if (all > LISTED) {
      String kinds = LISTED + " " + kind + "s";
      out.println("the " + kinds + " that are farthest from the " + centre + ", of " + all);
    }
    Table table = new Table(kind, "rays", "radiance");
    for (Replay.Sample each : listed) {
      String rays = Integer.toString(each.tree().rays().size());
      table.row(Integer.toString(each.number()), rays, each.tree().radiance().toString());
    }
    table.print(out);
  }

  /** Prints the rays that come of one; it was chosen for its distance, unless that is null. */
  private void printTree(Prepared scene, Replay.Sample shown, String kind, String centre) {
    PrintWriter out = spec.commandLine().getOut();
    String choice =
        centre == null ? "" : ", the farthest from the " + centre + "; --sample K shows another";
    out.printf(
        Locale.ROOT,
        "%n%s %d, at %.4f, %.4f in the pixel%s%n",
        kind,
        shown.number(),
        shown.x(),
        shown.y(),
        choice);
    RayTreeText.of(scene, shown.tree()).forEach(out::println);
  }

  private void printValue(Scene scene, RenderSettings settings, String what, Rgb value) {
    PrintWriter out = spec.commandLine().getOut();
    String place = "pixel " + pixel[0] + "," + pixel[1];
    String size = settings.width() + "x" + settings.height();
    out.println(scene.name() + ": " + place + " of " + size);
    Transfer codes = scene.transfer();
    String code =
        codes.code(value.r()) + ", " + codes.code(value.g()) + ", " + codes.code(value.b());
    out.println(what + ", as PNG " + code);
  }
}

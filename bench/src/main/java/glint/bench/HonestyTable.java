package glint.bench;

import glint.render.Goal;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.report.Errors;
import glint.report.Honesty;
import glint.report.Honesty.Claim;
import glint.report.Reference;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Asks for many images and compares what they claim of their errors with the truth; and what they
 * cost with what as many samples for every pixel cost.
 */
public final class HonestyTable {

  private final Map<String, String> options = new LinkedHashMap<>();
  private final References references;
  private final UniformErrors uniform;
  private Score score = new Score();

  private HonestyTable(Path folder) throws IOException {
    references = new References(folder);
    uniform = new UniformErrors(folder);
    options.put("targets", "4,2,1,0.5");
    options.put("samples", "");
    options.put("seeds", "5");
    options.put("size", "160x120");
    options.put("scenes", "");
    options.put("time", "0");
  }

  /**
   * Prints the tables.
   *
   * @param args a folder for references, the commit, scene files, and options such as {@code
   *     targets=4,2,1,0.5}, {@code seeds=5}, {@code size=160x120} or {@code size=own}, {@code
   *     time=1} for seconds of timing, {@code scenes=stones,colonnade}, these in any place
   */
  public static void main(String[] args) throws IOException {
    List<String> plain = new ArrayList<>(List.of(args));
    plain.removeIf(arg -> arg.contains("="));
    HonestyTable table = new HonestyTable(Path.of(plain.get(0)));
    for (String arg : args) {
      String[] parts = arg.split("=", 2);
      if (parts.length == 2 && table.options.put(parts[0], parts[1]) == null) {
        throw new IllegalArgumentException("no option is called " + parts[0]);
      }
    }
    System.out.printf(
        "%s, one thread, CPU seconds. Options: %s.%n%n", Machine.with(plain.get(1)), table.options);
    table.run(plain.subList(2, plain.size()));
  }

  private void run(List<String> files) throws IOException {
    System.out.println(
        "| scene | target | kept | true/claimed | least | most | true | claimed | truncation"
            + " | off by | samples | most | rays | uniform | fewer rays | seconds | faster |");
    System.out.println("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
    List<String> names = list("scenes");
    Map<String, Score> scores = new LinkedHashMap<>();
    for (String file : files) {
      score = new Score();
      for (Scene scene : Scenes.read(Path.of(file))) {
        if (names.isEmpty() || names.contains(scene.name())) {
          measure(scene);
        }
      }
      if (!score.claims.isEmpty()) {
        scores.put(Path.of(file).getFileName().toString(), score);
      }
    }
    System.out.println();
    System.out.println(
        "| file | runs | kept | true/claimed | least | most | fewer rays | least | faster | least |");
    System.out.println("|---|---|---|---|---|---|---|---|---|---|");
    Score all = new Score();
    scores.forEach(
        (file, each) -> {
          each.print(file);
          all.add(each);
        });
    all.print("all");
  }

  private void measure(Scene scene) throws IOException {
    boolean own = options.get("size").equals("own");
    String[] size = options.get("size").split("x");
    int width = own ? scene.width() : Integer.parseInt(size[0]);
    int height = own ? scene.height() : Integer.parseInt(size[1]);
    int cores = Runtime.getRuntime().availableProcessors();
    RenderSettings settings =
        new RenderSettings(width, height, 1, 0, OptionalInt.empty(), cores, 32, Set.of());
    Prepared prepared = Prepared.of(scene);
    Reference reference = references.of(prepared, settings);
    for (String target : list("targets")) {
      measure(prepared, settings, reference, new Goal.Error(Double.parseDouble(target)));
    }
    for (String samples : list("samples")) {
      measure(prepared, settings, reference, new Goal.Samples(Integer.parseInt(samples)));
    }
  }

  private List<String> list(String option) {
    String values = options.get(option);
    return values.isEmpty() ? List.of() : List.of(values.split(","));
  }

  private void measure(Prepared scene, RenderSettings settings, Reference reference, Goal goal)
      throws IOException {
    List<Claim> claims = new ArrayList<>();
    List<Errors> errors = new ArrayList<>();
    double claimed = 0;
    double truncation = 0;
    double samples = 0;
    int most = 0;
    double rays = 0;
    int seeds = Integer.parseInt(options.get("seeds"));
    for (int seed = 0; seed < seeds; seed++) {
      RenderResult run = Race.render(scene, settings, goal, seed);
      Errors error = reference.errors(run.image());
      double claim = run.statistics().samplingError() + run.statistics().truncation();
      errors.add(error);
      claims.add(
          new Claim(
              goal instanceof Goal.Error asked ? asked.levels() : claim, claim, error.levels()));
      claimed += claim / seeds;
      truncation += run.statistics().truncation() / seeds;
      samples += run.statistics().meanSamples() / seeds;
      most = Math.max(most, run.statistics().maxSamples());
      rays += (double) run.statistics().rays().total() / seeds;
    }
    double actual = Errors.together(errors).levels();
    UniformErrors.Need need =
        goal instanceof Goal.Samples
            ? new UniformErrors.Need(most, rays, true)
            : uniform.need(scene, settings, reference, actual);
    Race race = new Race(scene, settings, goal);
    race.run(Double.parseDouble(options.get("time")));
    double faster = need.samples() * race.sampleSeconds() / race.targetSeconds();
    score.add(claims, need, need.rays() / rays, faster);
    Honesty honesty = Honesty.of(claims);
    System.out.printf(
        Locale.ROOT,
        "| %s | %s | %.0f %% | %.2f | %.2f | %.2f | %.3f | %.3f | %.4f | %.3f | %.2f | %d | %.2f M"
            + " | %s%d | %.2f | %s | %s |%n",
        scene.scene().name(),
        goal instanceof Goal.Samples fixed
            ? fixed.count() + " samples"
            : ((Goal.Error) goal).levels(),
        100 * honesty.kept(),
        honesty.ratio().median(),
        honesty.ratio().min(),
        honesty.ratio().max(),
        actual,
        claimed,
        truncation,
        reference.uncertainty(),
        samples,
        most,
        rays * 1e-6,
        need.reached() ? "" : ">",
        need.samples(),
        need.rays() / rays,
        time(race.targetSeconds()),
        time(faster));
  }

  private static String time(double seconds) {
    return seconds == 0 ? "–" : String.format(Locale.ROOT, "%.4f", seconds);
  }
}

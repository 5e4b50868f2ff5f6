package glint.bench;

import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.report.Errors;
import glint.report.Reference;
import glint.scene.Prepared;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** How much an image is off with so many samples for every pixel; kept in a folder. */
final class UniformErrors {

  /** The most samples that are tried. */
  private static final int MOST = 256;

  /** Runs of each number of samples. */
  private static final int RUNS = 2;

  /**
   * What an error needs.
   *
   * @param samples of every pixel, the fewest that reach it
   * @param rays of all kinds
   * @param reached whether they do reach it; else more are needed
   */
  record Need(int samples, double rays, boolean reached) {}

  private record Point(int samples, double levels, double rays) {}

  private final Path folder;

  UniformErrors(Path folder) {
    this.folder = folder;
  }

  /** Returns what an error needs; between powers of two, a power law of the error is taken. */
  Need need(Prepared scene, RenderSettings settings, Reference truth, double levels)
      throws IOException {
    Path file = folder.resolve(References.key(scene, settings) + "-uniform.txt");
    List<Point> points = new ArrayList<>();
    if (Files.exists(file)) {
      for (String line : Files.readAllLines(file)) {
        String[] parts = line.split(" ");
        points.add(
            new Point(
                Integer.parseInt(parts[0]),
                Double.parseDouble(parts[1]),
                Double.parseDouble(parts[2])));
      }
    }
    for (int i = 0; ; i++) {
      if (i == points.size()) {
        points.add(measure(scene, settings, truth, 1 << i));
        save(file, points);
      }
      Point point = points.get(i);
      if (point.levels <= levels || point.samples == MOST) {
        return need(i == 0 ? point : points.get(i - 1), point, levels);
      }
    }
  }

  private static Need need(Point before, Point after, double levels) {
    boolean reached = after.levels <= levels;
    double share = Math.log(before.levels / levels) / Math.log(before.levels / after.levels);
    boolean between = reached && before.samples < after.samples && after.levels > 0;
    int samples = between ? (int) Math.ceil(before.samples * Math.pow(2, share)) : after.samples;
    return new Need(samples, after.rays * samples / after.samples, reached);
  }

  private static Point measure(
      Prepared scene, RenderSettings settings, Reference truth, int samples) {
    List<Errors> errors = new ArrayList<>();
    double rays = 0;
    for (int seed = 0; seed < RUNS; seed++) {
      RenderSettings each = settings.sampled(samples, seed);
      RenderResult run = new Renderer(scene, each).render(Progress.NONE);
      errors.add(truth.errors(run.image()));
      rays += (double) run.statistics().rays().total() / RUNS;
    }
    return new Point(samples, Errors.together(errors).levels(), rays);
  }

  private static void save(Path file, List<Point> points) throws IOException {
    List<String> lines = new ArrayList<>();
    points.forEach(point -> lines.add(point.samples + " " + point.levels + " " + point.rays));
    Files.write(file, lines);
  }
}

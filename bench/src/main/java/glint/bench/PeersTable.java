package glint.bench;

import glint.bench.EqualError.Point;
import glint.color.Transfer;
import glint.image.Image;
import glint.report.Errors;
import glint.scene.Scene;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import javax.imageio.ImageIO;

/**
 * Compares what an error costs with Glint, and with the adaptive antialiasing of POV-Ray and of
 * Sunflow; see docs/bench-peers.md.
 */
public final class PeersTable {

  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;

  private static final int FILES = 3;

  /** References take so many by so many rays in a pixel, and more where these differ too much. */
  private static final int FINE = 16;

  private static final int FINER = 32;

  /** Renders of each setting, by turns; the fastest counts, as what else runs only slows down. */
  private static final int TURNS = 5;

  /** Settings that take more than so many CPU seconds have two turns only. */
  private static final double QUICK = 1;

  /** CPU seconds of renders in a turn at least: clocks count in hundredths. */
  private static final double TURN = 1;

  /** CPU seconds of a setting after which no slower ones are tried. */
  private static final double PATIENCE = 20;

  /** CPU seconds of renders before the turns, for what is compiled while it runs. */
  private static final double WARM_UP = 30;

  /** The most that two references may differ, in display levels. */
  private static final double SAME = 0.3;

  private static final Transfer TRANSFER = Transfer.SRGB;

  private final List<Peer> peers;
  private final List<Image> truths = new ArrayList<>();
  private final List<List<Point>> points = new ArrayList<>();

  private PeersTable(List<Peer> peers) {
    this.peers = peers;
  }

  /**
   * Prints the tables; exits with 1 if a renderer is missing or shows another picture.
   *
   * @param args names of scenes, then the commit, the folder of POV-Ray's scenes, that for images,
   *     and {@link #FILES} files of Glint's scenes
   */
  public static void main(String[] args) throws IOException {
    int named = args.length - FILES - 3;
    Path out = Files.createDirectories(Path.of(args[named + 2]));
    Povray povray = new Povray(Path.of(args[named + 1]), out.resolve("povray.log"));
    List<String> names = List.of(args).subList(0, named);
    List<Scene> scenes = new ArrayList<>();
    boolean good = true;
    try {
      System.out.printf(
          "%s and Sunflow against Glint: %s, load %s.%n",
          povray.version(), Machine.with(args[named]), Machine.load());
      for (String file : List.of(args).subList(named + 3, args.length)) {
        scenes.addAll(Scenes.read(Path.of(file)));
      }
      for (Scene scene : scenes) {
        if (names.contains(scene.name())) {
          Peer glint = new GlintPeer(scene, WIDTH, HEIGHT);
          Peer pov = new PovrayPeer(povray, scene, WIDTH, HEIGHT);
          PeersTable table = new PeersTable(List.of(glint, pov, sunflow(scene)));
          System.out.printf("%n## %s%n%n", scene.title());
          good &=
              table.samePicture(scene.name(), FINE, out)
                  || table.samePicture(scene.name(), FINER, out);
          table.measure();
          table.print();
        }
      }
    } catch (IOException e) {
      System.err.println(e.getMessage());
      System.exit(1);
    }
    System.exit(good ? 0 : 1);
  }

  private static Peer sunflow(Scene scene) throws IOException {
    try {
      return (Peer)
          Class.forName("glint.bench.SunflowPeer")
              .getConstructor(Scene.class, int.class, int.class)
              .newInstance(scene, WIDTH, HEIGHT);
    } catch (ReflectiveOperationException e) {
      throw new IOException("Sunflow was not found: install Debian's package libsunflow-java", e);
    }
  }

  /** Finds the references, keeps them as pictures, and prints how far they are apart. */
  private boolean samePicture(String scene, int fine, Path out) throws IOException {
    double most = 0;
    truths.clear();
    for (Peer peer : peers) {
      Image truth = KeptReference.of(peer, scene, fine, out);
      File file = out.resolve(scene + "-" + peer.name() + ".png").toFile();
      ImageIO.write(PovrayTable.picture(truth), "png", file);
      for (Image other : truths) {
        most = Math.max(most, Errors.between(truth, other, TRANSFER).levels());
      }
      truths.add(truth);
    }
    System.out.printf(
        Locale.ROOT,
        "The references of %d rays a pixel are at most %.2f levels apart (RMSE).%n%n",
        fine * fine,
        most);
    return most <= SAME;
  }

  private void measure() throws IOException {
    for (Peer peer : peers) {
      double warm = peer.warms() ? 0 : WARM_UP;
      for (int k = 0; warm < WARM_UP; k++) {
        warm += peer.render(peer.settings().get(k % peer.settings().size())).seconds();
      }
      points.add(new ArrayList<>());
    }
    for (int turn = 0; turn < TURNS; turn++) {
      for (int i = 0; i < peers.size(); i++) {
        List<Point> of = points.get(i);
        if (turn == 0) {
          first(peers.get(i), truths.get(i), of);
        } else {
          for (int k = 0; k < of.size(); k++) {
            Point point = of.get(k);
            if (turn > 1 && point.seconds() > QUICK) {
              continue;
            }
            double seconds = turn(peers.get(i), point.setting()).seconds();
            double faster = Math.min(seconds, point.seconds());
            of.set(k, new Point(point.setting(), point.levels(), faster));
          }
        }
      }
    }
  }

  /** Measures settings until they take too long. */
  private static void first(Peer peer, Image truth, List<Point> points) throws IOException {
    double seconds = 0;
    for (int k = 0; k < peer.settings().size() && seconds < PATIENCE; k++) {
      Peer.Run run = turn(peer, peer.settings().get(k));
      seconds = run.seconds();
      double levels = Errors.between(run.image(), truth, TRANSFER).levels();
      points.add(new Point(peer.settings().get(k), levels, seconds));
    }
  }

  /** Renders often enough to be timed; returns the image and the mean of the seconds. */
  private static Peer.Run turn(Peer peer, String setting) throws IOException {
    Peer.Run run = peer.render(setting);
    double seconds = run.seconds();
    int count = 1;
    for (; peer.warms() && seconds < TURN; count++) {
      seconds += peer.render(setting).seconds();
    }
    return new Peer.Run(run.image(), seconds / count);
  }

  private void print() {
    System.out.println("| renderer | setting | true error | seconds |\n|---|---|---|---|");
    for (int i = 0; i < peers.size(); i++) {
      for (Point point : EqualError.best(points.get(i))) {
        System.out.printf(
            Locale.ROOT,
            "| %s | `%s` | %.3f | %.3f |%n",
            peers.get(i).name(),
            point.setting(),
            point.levels(),
            point.seconds());
      }
    }
    System.out.println(
        "\n| at the error of | true error | Glint | POV-Ray | Sunflow | Glint / the faster |\n"
            + "|---|---|---|---|---|---|");
    for (Point glint : points.get(0)) {
      OptionalDouble povray = EqualError.seconds(points.get(1), glint.levels());
      OptionalDouble sunflow = EqualError.seconds(points.get(2), glint.levels());
      DoubleStream both = DoubleStream.concat(povray.stream(), sunflow.stream());
      System.out.printf(
          Locale.ROOT,
          "| %s | %.3f | %.3f | %s | %s | %s |%n",
          glint.setting(),
          glint.levels(),
          glint.seconds(),
          text("%.3f", povray),
          text("%.3f", sunflow),
          text("%.2f", both.map(peer -> glint.seconds() / peer).max()));
    }
  }

  private static String text(String format, OptionalDouble value) {
    return value.isPresent() ? String.format(Locale.ROOT, format, value.getAsDouble()) : "–";
  }
}

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
import javax.imageio.ImageIO;

/**
 * Compares what an error costs with Glint, and with the adaptive antialiasing of POV-Ray and of
 * Sunflow; see docs/bench-peers.md.
 */
public final class PeersTable {

  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;

  /** Renders of each setting, by turns; the fastest counts, as what else runs only slows down. */
  private static final int TURNS = 2;

  /** CPU seconds of renders in a turn at least: clocks count in hundredths. */
  private static final double TURN = 0.3;

  /** CPU seconds of renders before the turns, for what is compiled while it runs. */
  private static final double WARM_UP = 10;

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
   * @param args names of scenes, then the commit, the folder of the scenes, and that for images
   */
  public static void main(String[] args) throws IOException {
    int named = args.length - 3;
    Path folder = Path.of(args[named + 1]);
    Path out = Files.createDirectories(Path.of(args[named + 2]));
    Povray povray = new Povray(folder, out.resolve("povray.log"));
    List<String> names = List.of(args).subList(0, named);
    boolean good = true;
    try {
      System.out.printf(
          "%s and Sunflow against Glint: %s, load %s.%n",
          povray.version(), Machine.with(args[named]), Machine.load());
      for (Scene scene : Scenes.read(folder.resolve("scenes.yaml"))) {
        if (names.contains(scene.name())) {
          Peer glint = new GlintPeer(scene, WIDTH, HEIGHT);
          Peer pov = new PovrayPeer(povray, scene.name(), WIDTH, HEIGHT);
          PeersTable table = new PeersTable(List.of(glint, pov, sunflow(scene)));
          System.out.printf("%n## %s%n%n", scene.title());
          good &= table.samePicture(scene.name(), out);
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
  private boolean samePicture(String scene, Path out) throws IOException {
    double most = 0;
    for (Peer peer : peers) {
      Image truth = KeptReference.of(peer, scene, out);
      File file = out.resolve(scene + "-" + peer.name() + ".png").toFile();
      ImageIO.write(PovrayTable.picture(truth), "png", file);
      for (Image other : truths) {
        most = Math.max(most, Errors.between(truth, other, TRANSFER).levels());
      }
      truths.add(truth);
    }
    System.out.printf(
        Locale.ROOT, "The references are at most %.2f levels apart (RMSE).%n%n", most);
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
        List<String> settings = peers.get(i).settings();
        for (int k = 0; k < settings.size(); k++) {
          Peer.Run run = turn(peers.get(i), settings.get(k));
          double levels = Errors.between(run.image(), truths.get(i), TRANSFER).levels();
          if (turn == 0) {
            points.get(i).add(new Point(settings.get(k), levels, run.seconds()));
          } else if (run.seconds() < points.get(i).get(k).seconds()) {
            points.get(i).set(k, new Point(settings.get(k), levels, run.seconds()));
          }
        }
      }
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
      double faster =
          Math.min(
              povray.orElse(Double.POSITIVE_INFINITY), sunflow.orElse(Double.POSITIVE_INFINITY));
      System.out.printf(
          Locale.ROOT,
          "| %s | %.3f | %.3f | %s | %s | %.2f |%n",
          glint.setting(),
          glint.levels(),
          glint.seconds(),
          text(povray),
          text(sunflow),
          glint.seconds() / faster);
    }
  }

  private static String text(OptionalDouble seconds) {
    return seconds.isPresent() ? String.format(Locale.ROOT, "%.3f", seconds.getAsDouble()) : "–";
  }
}

package glint.desktop.window;

import glint.color.Transfer;
import glint.image.Image;
import glint.render.Aov;
import glint.report.Errors;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** Decides what is seen of a render: its picture, a map of it, or it beside another image. */
final class Viewing {

  private static final Scale LEVELS = new Scale("Estimated error in display levels", 0.01, 100);
  private static final Scale OFF = new Scale("Difference in display levels", 0.01, 100);

  private final Consumer<BufferedImage> view;
  private final Strip strip;
  private final Workers workers;
  private Look look = Look.PICTURE;
  private Picked picked;
  private Snapshot snapshot;
  private Comparand other;
  private String words = " ";
  private int scene;
  private boolean busy;
  private boolean stale;

  /**
   * Sets up a view of nothing.
   *
   * @param view shows pictures
   */
  Viewing(Consumer<BufferedImage> view, Workers workers) {
    this.view = view;
    this.workers = workers;
    strip = new Strip(this::refresh);
  }

  /** Returns what stands below the view. */
  Strip strip() {
    return strip;
  }

  /** Returns what is compared with. */
  Optional<Comparand> other() {
    return Optional.ofNullable(other);
  }

  /** Another scene follows: what is being made of the one before is not shown. */
  void begin(Picked next) {
    scene++;
    picked = next;
    snapshot = null;
  }

  /** Nothing follows. */
  void end() {
    begin(null);
    other = null;
    view.accept(null);
  }

  /** Returns which scene is seen. */
  Optional<Picked> picked() {
    return Optional.ofNullable(picked);
  }

  /** Returns where its render stands. */
  Optional<Snapshot> snapshot() {
    return Optional.ofNullable(snapshot);
  }

  /** Shows where a render stands. */
  void show(Snapshot next) {
    boolean over = snapshot == null || snapshot.state() != next.state();
    snapshot = next;
    if (over && next.state().isOver()) {
      measure();
    }
    refresh();
  }

  /** Shows another side of it. */
  void show(Look next) {
    look = next;
    refresh();
  }

  /** Compares with another image from now on. */
  void compare(Comparand next) {
    other = next;
    measure();
    refresh();
  }

  private void refresh() {
    if (snapshot == null || snapshot.picture().isEmpty()) {
      return;
    }
    Optional<Supplier<BufferedImage>> maker = maker();
    if (maker.isEmpty()) {
      // A strip that is there stays while the camera moves: the picture would jump.
      boolean map = look == Look.ERROR || look == Look.SAMPLES;
      strip.setVisible(look.compares() ? other != null : map && strip.isVisible());
      view.accept(snapshot.picture().get());
    } else if (busy) {
      stale = true;
    } else {
      busy = true;
      Look made = look;
      int of = scene;
      workers.compute(
          () -> {
            BufferedImage picture = maker.get().get();
            SwingUtilities.invokeLater(() -> made(made, of, picture));
          });
    }
  }

  private void made(Look made, int of, BufferedImage picture) {
    busy = false;
    if (made == look && of == scene) {
      view.accept(picture);
    }
    if (stale || made != look) {
      stale = false;
      refresh();
    }
  }

  /** Returns what makes the picture to show, if it is not the render's own. */
  private Optional<Supplier<BufferedImage>> maker() {
    if (look.compares()) {
      return fits() ? Optional.of(comparison()) : noComparison();
    }
    boolean known = snapshot.findings().isPresent() && snapshot.error() < Double.POSITIVE_INFINITY;
    if (look == Look.PICTURE || !known) {
      return Optional.empty();
    }
    Aov aov = look == Look.ERROR ? Aov.ERROR : Aov.SAMPLES;
    Image map = snapshot.findings().get().maps().get(aov);
    Scale scale = look == Look.ERROR ? LEVELS : Scale.counts("Samples", largest(map));
    strip.showLegend(scale, " ");
    return Optional.of(() -> Palette.picture(map, scale));
  }

  private Supplier<BufferedImage> comparison() {
    if (look == Look.SPLIT) {
      strip.showDivider("Render", other.file().getFileName().toString(), words);
      BufferedImage picture = snapshot.picture().get();
      BufferedImage right = other.picture();
      double part = strip.divider();
      return () -> Pictures.beside(picture, right, part);
    }
    strip.showLegend(OFF, words);
    Image image = snapshot.linear().get();
    Comparand reference = other;
    return () -> difference(image, reference);
  }

  private Optional<Supplier<BufferedImage>> noComparison() {
    if (other != null) {
      strip.showDivider("Render", other.file().getFileName().toString(), words);
    }
    return Optional.empty();
  }

  private static BufferedImage difference(Image image, Comparand reference) {
    double[] levels = Errors.ofPixels(image, reference.image(), reference.transfer());
    int[] codes = Arrays.stream(levels).mapToInt(e -> Palette.colour(OFF.place(e))).toArray();
    return Pictures.of(codes, image.width(), image.height());
  }

  private static double largest(Image map) {
    double largest = 1;
    for (int i = 0; i < map.rgb().length; i += 3) {
      largest = Math.max(largest, map.rgb()[i]);
    }
    return largest;
  }

  private boolean fits() {
    return other != null
        && snapshot.linear().isPresent()
        && other.image().width() == snapshot.linear().get().width()
        && other.image().height() == snapshot.linear().get().height();
  }

  /** Measures in the background how far the image is from the other one. */
  private void measure() {
    if (other == null || snapshot == null || snapshot.linear().isEmpty()) {
      return;
    }
    Image image = snapshot.linear().get();
    if (!fits()) {
      words = "cannot be compared: it has " + size(other.image()) + " pixels, not " + size(image);
      return;
    }
    Transfer transfer = other.transfer();
    Image reference = other.image();
    words = "measuring";
    workers.compute(
        () -> {
          String found = Metrics.words(image, reference, transfer);
          SwingUtilities.invokeLater(
              () -> {
                words = found;
                refresh();
              });
        });
  }

  private static String size(Image image) {
    return image.width() + "x" + image.height();
  }
}

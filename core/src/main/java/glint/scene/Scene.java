package glint.scene;

import glint.color.Transfer;
import glint.light.Light;
import glint.math.BadValueException;
import glint.optics.Highlight;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What a person wrote: a camera, lights and surfaces, and the picture to make of them; immutable.
 *
 * @param name the name of the image file and of {@code --scene}
 * @param title a line for people
 * @param width columns of the image
 * @param height rows of the image
 * @param maxDepth the most successive bounces, if the scene's format states it
 * @param expectations what the picture must show, for those who verify it
 * @param turntable the camera's way, if there is more than one picture
 */
public record Scene(
    String name,
    String title,
    int width,
    int height,
    Camera camera,
    Background background,
    List<Light> lights,
    List<Placement> placements,
    Highlight highlight,
    Transfer transfer,
    OptionalInt maxDepth,
    List<Expectation> expectations,
    Optional<Turntable> turntable) {

  /** The most pixels of an image: their linear values fill one Java array. */
  public static final int MAX_PIXELS = (Integer.MAX_VALUE - 8) / 3;

  /**
   * Checks name, image size, the pixels that are expected and the turntable's frames, and copies
   * the lists.
   */
  public Scene {
    checkName(name);
    checkSize(width, height);
    lights = List.copyOf(lights);
    placements = List.copyOf(placements);
    expectations = List.copyOf(expectations);
    for (Expectation each : expectations) {
      each.pixel().ifPresent(pixel -> checkPixel(pixel, width, height));
    }
    int frames = turntable.map(Turntable::frames).orElse(0);
    for (int frame = 1; frame <= frames; frame++) {
      checkName(name + Turntable.suffix(frame));
      turntable.get().camera(camera, frame);
    }
  }

  /** Returns the pictures of a turntable, each a scene of its own, or only this scene. */
  public List<Scene> frames() {
    List<Scene> frames = new ArrayList<>();
    turntable.ifPresent(
        table -> {
          for (int frame = 1; frame <= table.frames(); frame++) {
            frames.add(frame(table, frame));
          }
        });
    return frames.isEmpty() ? List.of(this) : frames;
  }

  private Scene frame(Turntable table, int frame) {
    return picture(name + Turntable.suffix(frame), width, height, table.camera(camera, frame));
  }

  /** Returns another picture of the same world, of which nothing is expected. */
  public Scene seenBy(Camera other, int newWidth, int newHeight) {
    return picture(name, newWidth, newHeight, other);
  }

  private Scene picture(String newName, int newWidth, int newHeight, Camera newCamera) {
    return new Scene(
        newName,
        title,
        newWidth,
        newHeight,
        newCamera,
        background,
        lights,
        placements,
        highlight,
        transfer,
        maxDepth,
        List.of(),
        Optional.empty());
  }

  /**
   * Checks that a pixel lies in an image.
   *
   * @throws BadValueException if it does not
   */
  private static void checkPixel(Expectation.Pixel pixel, int width, int height) {
    if (pixel.x() < 0 || pixel.x() >= width || pixel.y() < 0 || pixel.y() >= height) {
      throw new BadValueException(
          "pixel",
          String.format(
              Locale.ROOT,
              "must lie in the image, from [0, 0] to [%d, %d], but is [%d, %d]",
              width - 1,
              height - 1,
              pixel.x(),
              pixel.y()));
    }
  }

  /**
   * Checks a scene's name, which becomes a file's name.
   *
   * @throws BadValueException unless it is 1 to 100 letters, digits, spaces or {@code . _ - + ( )},
   *     begins with neither a dot, a dash nor a space, and does not end with a dot or a space
   */
  public static void checkName(String name) {
    boolean ok = !name.isEmpty() && name.length() <= 100 && ".- ".indexOf(name.charAt(0)) < 0;
    for (int i = 0; ok && i < name.length(); i++) {
      char c = name.charAt(i);
      ok = Character.isLetterOrDigit(c) || " ._-+()".indexOf(c) >= 0;
    }
    ok = ok && ". ".indexOf(name.charAt(name.length() - 1)) < 0;
    if (!ok) {
      throw new BadValueException(
          "name",
          "becomes a file's name: use up to 100 letters, digits, '-', '_', '.', '+', '(', ')' and"
              + " spaces, but not '"
              + name
              + "'");
    }
  }

  /**
   * Checks the size of an image.
   *
   * @throws BadValueException unless both sides are at least 1 and the image can be held
   */
  public static void checkSize(int width, int height) {
    if (width < 1) {
      throw new BadValueException("width", "must be at least 1, but is " + width);
    }
    if (height < 1) {
      throw new BadValueException("height", "must be at least 1, but is " + height);
    }
    if ((long) width * height > MAX_PIXELS) {
      throw new BadValueException(
          "width",
          "times height must be at most " + MAX_PIXELS + " pixels: " + width + "x" + height);
    }
  }

  /** Collects the parts of a scene; only the camera has no default. */
  public static final class Builder {

    private final String name;
    private final List<Light> lights = new ArrayList<>();
    private final List<Placement> placements = new ArrayList<>();
    private final List<Expectation> expectations = new ArrayList<>();
    private String title = "";
    private int width = 640;
    private int height = 480;
    private Camera camera;
    private Background background = Background.BLACK;
    private Highlight highlight = Highlight.BLINN;
    private Transfer transfer = Transfer.SRGB;
    private OptionalInt maxDepth = OptionalInt.empty();
    private Optional<Turntable> turntable = Optional.empty();

    /** Begins a scene of 640×480 pixels on black, with Blinn highlights and sRGB output. */
    public Builder(String name) {
      this.name = name;
    }

    /** Sets the line for people. */
    public Builder title(String value) {
      title = value;
      return this;
    }

    /** Sets the size of the image in pixels. */
    public Builder size(int newWidth, int newHeight) {
      width = newWidth;
      height = newHeight;
      return this;
    }

    /** Sets the camera. */
    public Builder camera(Camera value) {
      camera = value;
      return this;
    }

    /** Sets the light of rays that meet nothing. */
    public Builder background(Background value) {
      background = value;
      return this;
    }

    /** Adds a light. */
    public Builder light(Light value) {
      lights.add(value);
      return this;
    }

    /** Adds a surface at its place. */
    public Builder place(Placement value) {
      placements.add(value);
      return this;
    }

    /**
     * Adds something that the picture, whose size is set, must show.
     *
     * @throws BadValueException if it speaks of a pixel outside
     */
    public Builder expect(Expectation value) {
      value.pixel().ifPresent(pixel -> checkPixel(pixel, width, height));
      expectations.add(value);
      return this;
    }

    /** Sets the kind of highlights. */
    public Builder highlight(Highlight value) {
      highlight = value;
      return this;
    }

    /** Sets the curve of the output. */
    public Builder transfer(Transfer value) {
      transfer = value;
      return this;
    }

    /** Sets the most successive bounces. */
    public Builder maxDepth(int value) {
      maxDepth = OptionalInt.of(value);
      return this;
    }

    /** Sets the camera's way. */
    public Builder turntable(Turntable value) {
      turntable = Optional.of(value);
      return this;
    }

    /**
     * Returns the scene.
     *
     * @throws BadValueException if there is no camera or the name or size is not usable
     */
    public Scene build() {
      if (camera == null) {
        throw new BadValueException("camera", "is missing");
      }
      return new Scene(
          name,
          title.isEmpty() ? name : title,
          width,
          height,
          camera,
          background,
          lights,
          placements,
          highlight,
          transfer,
          maxDepth,
          expectations,
          turntable);
    }
  }
}

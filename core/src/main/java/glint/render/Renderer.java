package glint.render;

import glint.image.Image;
import glint.scene.Prepared;
import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ThreadFactory;

/**
 * Renders one image on a fixed number of threads.
 *
 * <p>The image is the same, bit for bit, for any number of threads and any size of tiles.
 */
public final class Renderer {

  private final Prepared scene;
  private final RenderSettings settings;
  private final Image image;
  private final Map<Aov, Image> aovs = new EnumMap<>(Aov.class);
  private final PixelWatch watch;
  private final Gate gate = new Gate();

  /** Sets up a render; nothing runs yet. */
  public Renderer(Prepared scene, RenderSettings settings) {
    this(scene, settings, null);
  }

  /** Sets up a render to an error, of which a pixel is watched, if not null. */
  Renderer(Prepared scene, RenderSettings settings, PixelWatch watch) {
    this.watch = watch;
    this.scene = scene;
    this.settings = settings;
    image = new Image(settings.width(), settings.height());
    for (Aov aov : settings.aovs()) {
      aovs.put(aov, new Image(settings.width(), settings.height()));
    }
  }

  /**
   * Renders the image; call it once, or another {@code render}.
   *
   * @throws CancellationException if {@link #cancel} was called, or the thread was interrupted
   */
  public RenderResult render(Progress progress) {
    return render(progress, Renderer::thread);
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "glint-render");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Renders the image on threads that a platform makes as it needs them: of a priority, say.
   *
   * @throws CancellationException if {@link #cancel} was called, or the thread was interrupted
   */
  public RenderResult render(Progress progress, ThreadFactory threads) {
    long began = System.nanoTime();
    Method method =
        settings.goal() instanceof Goal.Error goal
            ? new TargetRender(scene, settings, goal, image, aovs, watch)
            : new UniformRender(scene, settings, image, aovs);
    Traced traced;
    try {
      traced = method.run(progress, gate::closed, threads);
    } catch (InterruptedException e) {
      cancel();
      Thread.currentThread().interrupt();
      throw new CancellationException("rendering was interrupted");
    }
    double seconds = (System.nanoTime() - began) * 1e-9;
    return new RenderResult(image, aovs, statistics(traced, seconds));
  }

  /** Stops the render soon; may be called from any thread. */
  public void cancel() {
    gate.close();
  }

  /** Has the workers wait soon, until {@link #resume}; may be called from any thread. */
  public void pause() {
    gate.hold(true);
  }

  /** Has the workers go on after {@link #pause}; may be called from any thread. */
  public void resume() {
    gate.hold(false);
  }

  /** Returns the image, not a copy: it grows while tiles finish. */
  public Image image() {
    return image;
  }

  /**
   * Returns the extra pictures, not copies. In a render to an error those of the render itself,
   * {@link Aov#ERROR} and {@link Aov#SAMPLES}, are up to date whenever {@link
   * Progress#pictureImproved} is heard with a finite error; the others are filled at the end.
   */
  public Map<Aov, Image> aovs() {
    return Collections.unmodifiableMap(aovs);
  }

  private Statistics statistics(Traced traced, double seconds) {
    return new Statistics(
        traced.rays(),
        traced.minSamples(),
        traced.meanSamples(),
        traced.maxSamples(),
        scene.primitiveCount(),
        scene.geometryBytes(),
        traced.invalid(),
        traced.invalidPixel(),
        ImageFacts.clipped(image),
        traced.samplingError(),
        ImageFacts.truncation(image, traced.cut(), scene.scene().transfer()),
        seconds);
  }
}

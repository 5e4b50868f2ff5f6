package glint.bench;

import com.sun.management.OperatingSystemMXBean;
import glint.image.Image;
import glint.scene.Scene;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.sunflow.PluginRegistry;
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.core.Filter;
import org.sunflow.image.Color;
import org.sunflow.system.UI;
import org.sunflow.system.ui.SilentInterface;

/** Sunflow with its adaptive antialiasing; compiled where Sunflow is installed. */
public final class SunflowPeer implements Peer {

  /** The share of a ray's light that is not followed, and that of the reference. */
  private static final float CUTOFF = 1e-3f;

  private static final float FINE_CUTOFF = 1e-5f;

  private static final OperatingSystemMXBean SYSTEM =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  private final SunflowAPI api;
  private final int width;
  private final int height;

  /** Builds a scene of spheres and boxes under ambient light and lamps without fall-off. */
  public SunflowPeer(Scene scene, int width, int height) {
    this.width = width;
    this.height = height;
    UI.set(new SilentInterface());
    if (!PluginRegistry.filterPlugins.hasType("pixel")) {
      PluginRegistry.filterPlugins.registerPlugin("pixel", PixelFilter.class);
    }
    api = SunflowScene.of(scene, width, height);
  }

  /**
   * A box filter of one pixel.
   *
   * <p>Sunflow visits samples only within (size − 1)/2 pixels of a pixel's first one, so that its
   * own filter of size 1 sees one of them; this says size 3 and leaves out what is outside.
   */
  public static final class PixelFilter implements Filter {
    @Override
    public float getSize() {
      return 3;
    }

    @Override
    public float get(float x, float y) {
      return Math.abs(x) <= 0.5f && Math.abs(y) <= 0.5f ? 1 : 0;
    }
  }

  @Override
  public String name() {
    return "Sunflow";
  }

  @Override
  public List<String> settings() {
    List<String> settings = new ArrayList<>();
    for (int sum = 0; sum <= 6; sum++) {
      for (int max = (sum + 1) / 2; max <= Math.min(sum, 4); max++) {
        int min = sum - max;
        for (double contrast : new double[] {0.1, 0.02}) {
          if (min < max || contrast == 0.1) {
            settings.add(
                String.format(
                    Locale.ROOT, "aa.min %d aa.max %d aa.contrast %s", min, max, contrast));
          }
        }
      }
    }
    return settings;
  }

  @Override
  public boolean warms() {
    return true;
  }

  @Override
  public Run render(String setting) {
    return render(setting, CUTOFF);
  }

  @Override
  public Image reference(int fine) {
    int halvings = Integer.numberOfTrailingZeros(fine);
    String setting = "aa.min " + halvings + " aa.max " + halvings + " aa.contrast 0";
    return render(setting, FINE_CUTOFF).image();
  }

  private Run render(String setting, float cutoff) {
    String[] words = setting.split(" ");
    api.parameter("sampler", "bucket");
    api.parameter("bucket.size", 64); // large ones fill the memory
    api.parameter("filter", "pixel");
    api.parameter("aa.min", Integer.parseInt(words[1]));
    api.parameter("aa.max", Integer.parseInt(words[3]));
    api.parameter("aa.contrast", Float.parseFloat(words[5]));
    api.parameter("resolutionX", width);
    api.parameter("resolutionY", height);
    api.parameter("threads", 1);
    api.parameter("depths.reflection", SunflowLaw.DEEPEST);
    api.parameter("depths.refraction", SunflowLaw.DEEPEST);
    api.parameter("camera", SunflowScene.CAMERA);
    api.options(SunflowAPI.DEFAULT_OPTIONS);
    SunflowLaw.cutOff(cutoff);
    Screen screen = new Screen(new Image(width, height));
    api.render(SunflowAPI.DEFAULT_OPTIONS, screen);
    return new Run(screen.image, (screen.ended - screen.began) * 1e-9);
  }

  /** Keeps the image, and the time between its begin and its end. */
  private static final class Screen implements Display {

    private final Image image;
    private long began;
    private long ended;

    private Screen(Image image) {
      this.image = image;
    }

    @Override
    public void imageBegin(int w, int h, int bucketSize) {
      began = SYSTEM.getProcessCpuTime();
    }

    @Override
    public void imagePrepare(int x, int y, int w, int h, int id) {}

    @Override
    public void imageUpdate(int x, int y, int w, int h, Color[] data, float[] alpha) {
      for (int i = 0; i < w * h; i++) {
        float[] rgb = data[i].getRGB();
        image.set(x + i % w, y + i / w, rgb[0], rgb[1], rgb[2]);
      }
    }

    @Override
    public void imageFill(int x, int y, int w, int h, Color c, float alpha) {}

    @Override
    public void imageEnd() {
      ended = SYSTEM.getProcessCpuTime();
    }
  }
}

package glint.bench;

import com.sun.management.OperatingSystemMXBean;
import glint.image.Image;
import glint.render.Goal;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Prepared;
import glint.scene.Scene;
import java.lang.management.ManagementFactory;
import java.util.List;

/** Glint, rendering to an error. */
final class GlintPeer implements Peer {

  private static final OperatingSystemMXBean SYSTEM =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  /** What the reference does not follow. */
  private static final double NEGLIGIBLE = 1e-5;

  private final Prepared scene;
  private final RenderSettings settings;

  GlintPeer(Scene scene, int width, int height) {
    this.scene = Prepared.of(scene);
    RenderSettings own = RenderSettings.of(scene);
    settings =
        new RenderSettings(
            width,
            height,
            own.goal(),
            0,
            own.maxDepth(),
            own.threads(),
            own.tileSize(),
            own.aovs());
  }

  @Override
  public String name() {
    return "Glint";
  }

  @Override
  public List<String> settings() {
    return List.of("target 4", "target 2", "target 1", "target 0.5", "target 0.25");
  }

  @Override
  public boolean warms() {
    return true;
  }

  @Override
  public Run render(String setting) {
    Goal goal = new Goal.Error(Double.parseDouble(setting.split(" ")[1]));
    long began = SYSTEM.getProcessCpuTime();
    Image image = Race.render(scene, settings, goal, 0).image();
    return new Run(image, (SYSTEM.getProcessCpuTime() - began) * 1e-9);
  }

  @Override
  public Image reference(int fine) {
    RenderSettings sampled = settings.sampled(fine * fine, -1).following(NEGLIGIBLE);
    return new Renderer(scene, sampled).render(Progress.NONE).image();
  }
}

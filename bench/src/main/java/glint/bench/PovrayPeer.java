package glint.bench;

import glint.geometry.Mesh;
import glint.image.Image;
import glint.scene.Placement;
import glint.scene.Scene;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** POV-Ray with its two methods of adaptive antialiasing. */
final class PovrayPeer implements Peer {

  /** The share of a ray's light that is not followed; a quarter of what it is by default. */
  private static final String BAILOUT = "Declare=Bailout=0.001";

  private static final List<String> THRESHOLDS = List.of("0.2", "0.05", "0.01");

  private final Povray povray;
  private final String scene;
  private final int width;
  private final int height;

  PovrayPeer(Povray povray, Scene scene, int width, int height) throws IOException {
    this.povray = povray;
    this.scene = scene.name();
    this.width = width;
    this.height = height;
    for (Placement placement : scene.placements()) {
      if (placement.surface() instanceof Mesh mesh) {
        povray.write(mesh, scene.name());
      }
    }
  }

  @Override
  public String name() {
    return "POV-Ray";
  }

  @Override
  public List<String> settings() {
    List<String> settings = new ArrayList<>(List.of("-A"));
    for (String shape : List.of("1 2", "2 1", "1 3", "2 2", "1 4", "2 3", "1 6", "2 4", "1 9")) {
      for (String threshold : THRESHOLDS) {
        String[] methodAndDepth = shape.split(" ");
        settings.add("+AM" + methodAndDepth[0] + " +A" + threshold + " +R" + methodAndDepth[1]);
      }
    }
    return settings;
  }

  @Override
  public boolean warms() {
    return false;
  }

  @Override
  public Run render(String setting) throws IOException {
    List<String> options = new ArrayList<>(List.of(setting.split(" ")));
    options.add(BAILOUT);
    return new Run(povray.render(scene, width, height, 1, options), povray.traceSeconds());
  }

  @Override
  public Image reference(int fine) throws IOException {
    return povray.render(scene, width, height, fine, List.of("-A", "Declare=Bailout=0.00001"));
  }
}

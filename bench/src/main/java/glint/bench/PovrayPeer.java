package glint.bench;

import glint.image.Image;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** POV-Ray with its two methods of adaptive antialiasing. */
final class PovrayPeer implements Peer {

  /** The share of a ray's light that is not followed; a quarter of what it is by default. */
  private static final String BAILOUT = "Declare=Bailout=0.001";

  /** The reference takes the mean of so many by so many rays. */
  private static final int FINE = 16;

  private static final List<String> THRESHOLDS = List.of("0.2", "0.05", "0.01");

  private final Povray povray;
  private final String scene;
  private final int width;
  private final int height;

  PovrayPeer(Povray povray, String scene, int width, int height) {
    this.povray = povray;
    this.scene = scene;
    this.width = width;
    this.height = height;
  }

  @Override
  public String name() {
    return "POV-Ray";
  }

  @Override
  public List<String> settings() {
    List<String> settings = new ArrayList<>(List.of("-A"));
    for (String threshold : THRESHOLDS) {
      for (int depth : new int[] {2, 3, 4, 6}) {
        settings.add("+AM1 +A" + threshold + " +R" + depth);
      }
      for (int depth : new int[] {1, 2, 3}) {
        settings.add("+AM2 +A" + threshold + " +R" + depth);
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
  public Image reference() throws IOException {
    return povray.render(scene, width, height, FINE, List.of("-A", "Declare=Bailout=0.00001"));
  }
}

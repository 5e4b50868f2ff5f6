package glint.verify;

import glint.color.Rgb;
import glint.color.Transfer;
import glint.geometry.Quad;
import glint.light.Light;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.RenderResult;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.List;
import java.util.Set;

/** From linear light to display codes. */
final class ColorCases {

  private static final Vector3d WIDE = new Vector3d(1, 0, 0);

  private ColorCases() {}

  static List<HardCase> all() {
    return List.of(
        HardCase.within("K01", "sRGB levels of known values", 5e-4, "levels", ColorCases::known),
        HardCase.exact("K02", "code → linear → code is the code", ColorCases::roundTrip),
        HardCase.exact("K03", "NaN and ∞ are counted and left out", ColorCases::notFinite),
        HardCase.exact("K05", "a pixel half white, half black is 188", ColorCases::half));
  }

  private static void known(Tally tally) {
    double[] linear = {0, 1, 0.5, 0.25, 0.18};
    double[] level = {0, 255, 187.516, 136.960, 117.646};
    int[] code = {0, 255, 188, 137, 118};
    for (int i = 0; i < linear.length; i++) {
      tally.check(Transfer.SRGB.code(linear[i]) == code[i]);
      tally.error(Math.abs(Transfer.SRGB.level(linear[i]) - level[i]));
    }
  }

  private static void roundTrip(Tally tally) {
    for (Transfer transfer : Transfer.values()) {
      for (int code = 0; code < 256; code++) {
        tally.check(transfer.code(transfer.decode(code / 255.0)) == code);
      }
    }
  }

  /** One pixel, its left half one material and its right half another, 64 samples. */
  private static RenderResult pixel(Scene.Builder scene, Material left, Material right) {
    Projection lens = Projection.vertical(1);
    Camera camera = Camera.of(new Vector3d(0, 0, 5), Vector3d.ZERO, Pictures.UP, lens);
    scene.size(1, 1).camera(camera);
    scene.place(Placement.of(new Quad(new Vector3d(-1, -1, 0), WIDE, new Vector3d(0, 2, 0)), left));
    scene.place(Placement.of(new Quad(new Vector3d(0, -1, 0), WIDE, new Vector3d(0, 2, 0)), right));
    return Pictures.render(scene.build(), 64, 1, 1, Set.of());
  }

  private static Material glowing(Rgb diffuse, double emission) {
    return new Material(Rgb.BLACK, diffuse, Rgb.BLACK, 1, Rgb.BLACK, Rgb.grey(emission));
  }

  /** A lamp so bright and near that it is infinite: red light is ∞, green and blue 0·∞. */
  private static void notFinite(Tally tally) {
    Material grey = glowing(Rgb.BLACK, 0.25);
    Light lamp = new Light.Point(new Vector3d(0, 0, 0.1), Rgb.grey(1.7e308), true);
    for (Rgb diffuse : new Rgb[] {new Rgb(1, 0, 0), Rgb.WHITE}) {
      Material broken = glowing(diffuse, 0);
      RenderResult half = pixel(new Scene.Builder("half").light(lamp), broken, grey);
      tally.check(half.statistics().invalid() == 32);
      tally.check(half.image().rgb()[0] == 0.25 && half.image().rgb()[1] == 0.25);
      RenderResult none = pixel(new Scene.Builder("none").light(lamp), broken, broken);
      tally.check(none.statistics().invalid() == 64);
      tally.check(none.image().rgb()[0] == 0 && none.image().rgb()[1] == 0);
    }
    for (Transfer transfer : Transfer.values()) {
      tally.check(transfer.code(Double.NaN) == 0);
      tally.check(transfer.code(Double.POSITIVE_INFINITY) == 255);
    }
  }

  private static void half(Tally tally) {
    Material white = glowing(Rgb.BLACK, 1);
    Material black = glowing(Rgb.BLACK, 0);
    Scene.Builder scene = new Scene.Builder("half").background(Background.constant(Rgb.WHITE));
    double linear = pixel(scene, white, black).image().rgb()[0];
    tally.check(linear == 0.5 && Transfer.SRGB.code(linear) == 188);
  }
}

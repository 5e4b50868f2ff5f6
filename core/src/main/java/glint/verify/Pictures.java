package glint.verify;

import glint.color.Rgb;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Aov;
import glint.render.Progress;
import glint.render.RenderResult;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Camera;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import java.util.OptionalInt;
import java.util.Set;

/** Small pictures for cases that need more than one ray. */
final class Pictures {

  static final Vector3d UP = new Vector3d(0, 1, 0);

  /** White and diffuse, without a share of ambient light: black means shadow. */
  static final Material CHALK =
      new Material(Rgb.BLACK, Rgb.WHITE, Rgb.BLACK, 1, Rgb.BLACK, Rgb.BLACK);

  private Pictures() {}

  /** Renders a scene with one sample in each pixel's centre. */
  static RenderResult render(Scene scene, Set<Aov> aovs) {
    return render(scene, 1, 1, RenderSettings.DEFAULT_TILE, aovs);
  }

  static RenderResult render(Scene scene, int samples, int threads, int tile, Set<Aov> aovs) {
    RenderSettings settings =
        new RenderSettings(
            scene.width(),
            scene.height(),
            samples,
            0,
            OptionalInt.empty(),
            threads,
            tile,
            Set.copyOf(aovs));
    return new Renderer(Prepared.of(scene), settings).render(Progress.NONE);
  }

  /** Returns the linear values of a scene's pixels, one sample each. */
  static double[] pixels(Scene.Builder scene) {
    return render(scene.build(), Set.of()).image().rgb();
  }

  /** Begins a scene that looks from one point to another, with a vertical angle of view. */
  static Scene.Builder looking(Vector3d from, Vector3d to, double degrees) {
    Vector3d view = to.minus(from).normalized();
    Vector3d up = Math.abs(view.y()) < 0.9 ? UP : new Vector3d(0, 0, 1);
    return new Scene.Builder("case")
        .size(64, 48)
        .camera(Camera.of(from, to, up, Projection.vertical(degrees)));
  }
}

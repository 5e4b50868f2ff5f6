package glint.android;

import glint.math.Vector3d;
import glint.scene.Camera;
import glint.scene.Lens;
import glint.scene.Orthographic;
import glint.scene.Projection;
import java.util.Optional;

/** What a hand can change of a camera, as numbers that outlive the app's process. */
final class CameraState {

  private CameraState() {}

  /** Returns eye, target, up, the height of a parallel view, and the lens's focus. */
  static double[] of(Camera camera) {
    Vector3d eye = camera.position();
    Vector3d target = camera.lookAt();
    Vector3d up = camera.up();
    boolean parallel = camera.projection() instanceof Orthographic;
    return new double[] {
      eye.x(),
      eye.y(),
      eye.z(),
      target.x(),
      target.y(),
      target.z(),
      up.x(),
      up.y(),
      up.z(),
      parallel ? ((Orthographic) camera.projection()).planeHeight() : 0,
      camera.lens().map(Lens::focus).orElse(0.0)
    };
  }

  /** Returns a scene's camera, moved to where the numbers say. */
  static Camera moved(Camera camera, double[] numbers) {
    Projection projection =
        camera.projection() instanceof Orthographic
            ? new Orthographic(numbers[9])
            : camera.projection();
    Optional<Lens> lens = camera.lens().map(l -> new Lens(l.radius(), numbers[10]));
    return new Camera(
        vector(numbers, 0),
        vector(numbers, 3),
        vector(numbers, 6),
        projection,
        camera.near(),
        camera.far(),
        lens);
  }

  private static Vector3d vector(double[] numbers, int at) {
    return new Vector3d(numbers[at], numbers[at + 1], numbers[at + 2]);
  }
}

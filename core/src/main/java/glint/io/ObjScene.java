package glint.io;

import glint.color.Rgb;
import glint.geometry.Mesh;
import glint.light.Light;
import glint.math.BadValueException;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Background;
import glint.scene.Camera;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import glint.scene.Projection;
import glint.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * Makes a scene of a model alone: it fills the picture, seen from the front, a little from the
 * right and from above, with a light from the upper left and a weaker one at the eye.
 */
final class ObjScene {

  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final double FIELD_OF_VIEW = 40;

  /** The share of the picture that the box around the model may fill. */
  private static final double FILLED = 0.9;

  private static final Vector3d TO_EYE = new Vector3d(0.45, 0.35, 1).normalized();
  private static final Vector3d UP = new Vector3d(0, 1, 0);
  private static final Background BACKGROUND = new Background(Rgb.grey(0.2), Rgb.grey(0.5));

  private final ObjModel model;
  private final ModelMaterials materials;
  private final String name;
  private final Problems own;

  private ObjScene(ObjModel model, String fileName, SceneFolder folder) {
    this.model = model;
    String itself = fileName.substring(folderEnd(fileName));
    materials = new ModelMaterials(model, itself, folder, new Images(folder));
    name = name(fileName);
    own = new Problems(fileName);
  }

  /**
   * Reads a model.
   *
   * @param folder opens what lies beside it
   * @throws IOException if the stream fails
   */
  static SceneFile read(InputStream in, String fileName, SceneFolder folder) throws IOException {
    ObjModel model = ObjReader.read(in, fileName);
    return model.mesh() == null
        ? new SceneFile(List.of(), List.of(name(fileName)), model.problems(), model.notes())
        : new ObjScene(model, fileName, folder).file();
  }

  private SceneFile file() {
    List<Problem> problems = new ArrayList<>(materials.problems());
    List<Problem> notes = new ArrayList<>();
    List<Scene> scenes = new ArrayList<>();
    if (model.mesh().triangles() == 0) {
      own.report(Place.NONE, "holds no faces: there is nothing to be seen");
    } else {
      notes.addAll(model.notes());
      notes.addAll(materials.notes());
      try {
        scenes.add(scene());
      } catch (BadValueException e) {
        own.report(Place.NONE, "the model cannot be framed: " + e.getMessage());
      }
    }
    problems.addAll(own.inFileOrder());
    return problems.isEmpty()
        ? new SceneFile(scenes, List.of(), problems, notes)
        : new SceneFile(List.of(), List.of(name), problems, notes);
  }

  private Scene scene() {
    List<NamedMaterial> made = new ArrayList<>();
    for (ModelPart part : materials.parts()) {
      Material own = part.material().orElse(Material.WHITE);
      made.add(new NamedMaterial(part.name(), own));
    }
    Camera camera = camera(model.mesh());
    Vector3d right = UP.cross(TO_EYE).normalized();
    Vector3d above = TO_EYE.cross(right);
    Vector3d toKey = TO_EYE.plus(above).minus(right.times(0.8));
    return new Scene.Builder(name)
        .size(WIDTH, HEIGHT)
        .camera(camera)
        .background(BACKGROUND)
        .light(new Light.Directional(toKey.negated(), Rgb.grey(0.75)))
        .light(new Light.Point(camera.position(), Rgb.grey(0.25), false))
        .place(new Placement(model.mesh(), Transform.IDENTITY, made, 0))
        .build();
  }

  /** Goes back so far that the box around all faces is in the picture. */
  private static Camera camera(Mesh mesh) {
    double[] box = box(mesh);
    Vector3d half = new Vector3d(box[3] - box[0], box[4] - box[1], box[5] - box[2]).times(0.5);
    Vector3d center = new Vector3d(box[0], box[1], box[2]).plus(half);
    Vector3d right = UP.cross(TO_EYE).normalized();
    Vector3d above = TO_EYE.cross(right);
    double high = FILLED * StrictMath.tan(StrictMath.toRadians(FIELD_OF_VIEW / 2));
    double wide = high * WIDTH / HEIGHT;
    double distance = 0;
    for (int i = 0; i < 8; i++) {
      Vector3d corner =
          new Vector3d(
              (i & 1) == 0 ? half.x() : -half.x(),
              (i & 2) == 0 ? half.y() : -half.y(),
              (i & 4) == 0 ? half.z() : -half.z());
      double aside = Math.abs(corner.dot(right)) / wide;
      double up = Math.abs(corner.dot(above)) / high;
      distance = Math.max(distance, corner.dot(TO_EYE) + Math.max(aside, up));
    }
    Vector3d eye = center.plus(TO_EYE.times(distance));
    return Camera.of(eye, center, UP, Projection.vertical(FIELD_OF_VIEW));
  }

  /** Returns the least and greatest coordinates of all corners. */
  private static double[] box(Mesh mesh) {
    double inf = Double.POSITIVE_INFINITY;
    double[] box = {inf, inf, inf, -inf, -inf, -inf};
    for (int i = 0; i < 3 * mesh.triangles(); i++) {
      for (int axis = 0; axis < 3; axis++) {
        double v = mesh.coordinate(i / 3, i % 3, axis);
        box[axis] = Math.min(box[axis], v);
        box[3 + axis] = Math.max(box[3 + axis], v);
      }
    }
    return box;
  }

  /** Returns the file's name without folder and ending, with what no scene's name has replaced. */
  private static String name(String fileName) {
    int end = fileName.length() - ".obj".length();
    StringBuilder name = new StringBuilder();
    for (char c : fileName.substring(folderEnd(fileName), end).toCharArray()) {
      name.append(isName("a" + c + "a") ? c : '_');
    }
    name.setLength(Math.min(name.length(), 100));
    while (name.length() > 0 && !isName(name.toString())) {
      boolean first = !isName(name.charAt(0) + "a");
      name.deleteCharAt(first ? 0 : name.length() - 1);
    }
    return name.length() == 0 ? "model" : name.toString();
  }

  private static int folderEnd(String fileName) {
    return Math.max(fileName.lastIndexOf('/'), fileName.lastIndexOf('\\')) + 1;
  }

  private static boolean isName(String name) {
    try {
      Scene.checkName(name);
      return true;
    } catch (BadValueException e) {
      return false;
    }
  }
}

package glint.io;

import glint.color.Transfer;
import glint.math.BadValueException;
import glint.math.Vector3d;
import glint.optics.Highlight;
import glint.scene.Camera;
import glint.scene.Perspective;
import glint.scene.Scene;
import java.util.HashMap;
import java.util.Map;

/** The commands of a CS 315 scene that concern the whole picture; each may stand once. */
final class Cs315Settings {

  private final String fileName;
  private final Problems problems;
  private final Problems notes;
  private final Map<String, Cs315Line> lines = new HashMap<>();

  Cs315Settings(String fileName, Problems problems, Problems notes) {
    this.fileName = fileName;
    this.problems = problems;
    this.notes = notes;
  }

  void set(Cs315Line line) {
    Cs315Line first = lines.putIfAbsent(line.command(), line);
    if (first != null) {
      problems.report(line.place(), line.command() + " is already given at line " + first.line());
    } else if (line.command().equals("ShadowBias")) {
      line.number(0);
      notes.report(
          line.place(), "ShadowBias " + line.argument(0) + " is not used: Glint needs none");
    }
  }

  /** Returns the scene's beginning; where it is not usable, problems are reported. */
  Scene.Builder begin() {
    for (String needed : new String[] {"Camera", "Output"}) {
      if (!lines.containsKey(needed)) {
        problems.report(Place.NONE, "the scene needs a line '" + needed + " …'");
      }
    }
    Scene.Builder scene = new Scene.Builder(lines.containsKey("Output") ? name() : "scene");
    scene.highlight(Highlight.PHONG).transfer(Transfer.LINEAR);
    if (lines.containsKey("BounceDepth")) {
      Cs315Line line = lines.get("BounceDepth");
      int depth = line.wholeNumber(0);
      if (depth < 0) {
        problems.report(line.argumentPlace(0), "BounceDepth must not be negative");
      }
      scene.maxDepth(depth);
    }
    double shape = lines.containsKey("Output") ? readSize(lines.get("Output"), scene) : 0;
    if (lines.containsKey("Camera")) {
      readCamera(lines.get("Camera"), shape, scene);
    }
    return scene;
  }

  /** Returns the image's width over its height. */
  private double readSize(Cs315Line line, Scene.Builder scene) {
    int width = line.wholeNumber(0);
    int height = line.wholeNumber(1);
    line.checked(() -> Scene.checkSize(width, height));
    scene.size(width, height);
    return (double) width / height;
  }

  private void readCamera(Cs315Line line, double shape, Scene.Builder scene) {
    Vector3d eye = line.vector(0);
    Vector3d up = line.vector(3);
    Vector3d lookAt = line.vector(6);
    double degrees = line.number(9);
    double aspect = line.number(10);
    line.checked(
        () -> {
          if (!(aspect > 0)) {
            throw new BadValueException("aspect", "must be positive, but is " + aspect);
          }
          Perspective p = new Perspective(degrees, false, aspect == shape ? 0 : aspect);
          scene.camera(Camera.of(eye, lookAt, up, p));
        });
  }

  /** Returns the name of the Output's file without folder and ending, or else of the scene's. */
  private String name() {
    Cs315Line line = lines.get("Output");
    String name = stem(line.argument(2));
    if (isName(name)) {
      return name;
    }
    String own = stem(fileName);
    if (isName(own)) {
      notes.report(
          line.argumentPlace(2),
          SourceText.quote(name) + " cannot be a scene's name: the scene is called '" + own + "'");
      return own;
    }
    problems.report(line.argumentPlace(2), SourceText.quote(name) + " cannot be a scene's name");
    return "scene";
  }

  private static boolean isName(String name) {
    try {
      Scene.checkName(name);
      return true;
    } catch (BadValueException e) {
      return false;
    }
  }

  private static String stem(String path) {
    String name = path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
    int dot = name.lastIndexOf('.');
    return dot < 0 ? name : name.substring(0, dot);
  }
}

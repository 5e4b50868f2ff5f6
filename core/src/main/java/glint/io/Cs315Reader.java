package glint.io;

import glint.color.Rgb;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.light.Light;
import glint.math.Check;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Reads the scene format of the course CS 315 (University of Puget Sound, 2013): one scene, a
 * command a line, with a stack of matrices and a current material.
 *
 * <p>Its scenes have Phong highlights and linear output, and a mirror adds to the local colour.
 */
final class Cs315Reader {

  private static final Map<String, Integer> ARGUMENTS = new TreeMap<>();

  /** What a later dialect of the format added. */
  private static final List<String> LATER =
      List.of(
          "Aperture",
          "AreaLight",
          "Box",
          "Compound",
          "Cylinder",
          "Focus",
          "Group",
          "ParticipatingMedia",
          "TMaterial",
          "TriangleMesh");

  static {
    ARGUMENTS.put("Camera", 11);
    ARGUMENTS.put("Output", 3);
    ARGUMENTS.put("BounceDepth", 1);
    ARGUMENTS.put("ShadowBias", 1);
    ARGUMENTS.put("PushMatrix", 0);
    ARGUMENTS.put("PopMatrix", 0);
    ARGUMENTS.put("Translate", 3);
    ARGUMENTS.put("Scale", 3);
    ARGUMENTS.put("Rotate", 3);
    ARGUMENTS.put("Sphere", 4);
    ARGUMENTS.put("Triangle", 9);
    ARGUMENTS.put("AmbientLight", 3);
    ARGUMENTS.put("PointLight", 6);
    ARGUMENTS.put("DirectionalLight", 6);
    ARGUMENTS.put("Material", 13);
  }

  private final Problems problems;
  private final Problems notes;
  private final Cs315Settings settings;
  private final Deque<Transform> stack = new ArrayDeque<>();
  private final List<Light> lights = new ArrayList<>();
  private final List<Placement> placements = new ArrayList<>();
  private Transform matrix = Transform.IDENTITY;
  private Material material;

  Cs315Reader(String fileName, Problems problems) {
    this.problems = problems;
    notes = new Problems(fileName);
    settings = new Cs315Settings(fileName, problems, notes);
  }

  SceneFile read(String text) {
    String[] lines = text.split("\r\n|\n|\r", -1);
    for (int i = 0; i < lines.length; i++) {
      Cs315Line line = new Cs315Line(i + 1, lines[i], problems);
      if (!line.isEmpty() && isKnown(line)) {
        obey(line);
      }
    }
    Scene.Builder scene = settings.begin();
    lights.forEach(scene::light);
    placements.forEach(scene::place);
    boolean sound = problems.reports() == 0;
    return new SceneFile(
        sound ? List.of(scene.build()) : List.of(),
        List.of(),
        problems.inFileOrder(),
        notes.inFileOrder());
  }

  private boolean isKnown(Cs315Line line) {
    String command = line.command();
    Integer arguments = ARGUMENTS.get(command);
    if (arguments == null) {
      line.report(
          line.place(),
          LATER.contains(command)
              ? command + " belongs to a later dialect of this format, which Glint cannot read"
              : "unknown command "
                  + SourceText.quote(command)
                  + Suggestion.hintOrList(command, ARGUMENTS.keySet()));
      return false;
    }
    if (command.equals("Material")) {
      material = Material.WHITE; // what follows has a material, even if this one cannot be read
    }
    if (line.arguments() != arguments) {
      String takes =
          arguments == 0 ? "no values" : arguments + (arguments == 1 ? " value" : " values");
      line.report(line.place(), command + " takes " + takes + ", but has " + line.arguments());
      return false;
    }
    return true;
  }

  private void obey(Cs315Line line) {
    switch (line.command()) {
      case "Camera", "Output", "BounceDepth", "ShadowBias" -> settings.set(line);
      case "PushMatrix" -> stack.push(matrix);
      case "PopMatrix" -> pop(line);
      case "Translate", "Scale", "Rotate" -> transform(line, line.vector(0));
      case "Material" -> setMaterial(line);
      case "Sphere", "Triangle" -> place(line);
      default -> addLight(line);
    }
  }

  private void pop(Cs315Line line) {
    if (stack.isEmpty()) {
      line.report(line.place(), "PopMatrix has no PushMatrix before it");
    } else {
      matrix = stack.pop();
    }
  }

  /** Multiplies the current matrix from the right, as OpenGL does: the new map comes first. */
  private void transform(Cs315Line line, Vector3d v) {
    line.checked(
        () -> {
          Check.finite(line.command(), v);
          Transform map =
              switch (line.command()) {
                case "Translate" -> Transform.translate(v);
                case "Scale" -> Transform.scale(v);
                default ->
                    about(0, 0, 1, v.z()).then(about(0, 1, 0, v.y())).then(about(1, 0, 0, v.x()));
              };
          Transform next = map.then(matrix);
          TransformReader.requireUsable(next);
          matrix = next;
        });
  }

  private static Transform about(double x, double y, double z, double degrees) {
    return Transform.rotate(Quaternion.aboutAxis(new Vector3d(x, y, z), degrees));
  }

  private void setMaterial(Cs315Line line) {
    Rgb ambient = line.color(0);
    Rgb diffuse = line.color(3);
    Rgb specular = line.color(6);
    Rgb mirror = line.color(9);
    double shininess = line.number(12);
    line.checked(
        () -> material = new Material(ambient, diffuse, specular, shininess, mirror, Rgb.BLACK));
  }

  private void addLight(Cs315Line line) {
    if (line.command().equals("AmbientLight")) {
      Rgb color = line.color(0);
      line.checked(() -> lights.add(new Light.Ambient(color)));
      return;
    }
    Vector3d v = line.vector(0);
    Rgb color = line.color(3);
    boolean point = line.command().equals("PointLight");
    line.checked(
        () ->
            lights.add(
                point
                    ? new Light.Point(matrix.point(v), color, false)
                    : new Light.Directional(matrix.direction(v), color)));
  }

  private void place(Cs315Line line) {
    if (material == null) {
      notes.report(
          line.place(), line.command() + " stands before the first Material: it is plain white");
      material = Material.WHITE;
    }
    Vector3d first = line.vector(0);
    if (line.command().equals("Sphere")) {
      double radius = line.number(3);
      line.checked(() -> place(new Sphere(first, radius), line));
    } else {
      Vector3d second = line.vector(3);
      Vector3d third = line.vector(6);
      line.checked(() -> place(new Triangle(first, second, third), line));
    }
  }

  private void place(Surface surface, Cs315Line line) {
    placements.add(
        new Placement(surface, matrix, List.of(new NamedMaterial("", material)), line.line()));
  }
}

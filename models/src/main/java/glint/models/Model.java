package glint.models;

import glint.math.Vector3d;
import glint.models.shape.Shape;
import java.util.LinkedHashMap;
import java.util.Map;

/** A model under construction: surfaces, each of one paint. */
final class Model {

  private final Map<Paint, Shape> parts = new LinkedHashMap<>();

  /** Adds a surface. */
  Model add(Paint paint, Shape shape) {
    parts.merge(paint, shape, Shape::plus);
    return this;
  }

  /** Returns a model of one surface, without a paint: the scene says what it is made of. */
  static Model of(Shape shape) {
    return new Model().add(new Paint("", ""), shape);
  }

  /** Returns the text of the OBJ file. */
  String obj(String name) {
    StringBuilder text = new StringBuilder("# Made by ./gradlew -q :models:write\n");
    if (isPainted()) {
      text.append("mtllib ").append(name).append(".mtl\n");
    }
    int[] before = {1};
    parts.forEach(
        (paint, shape) -> {
          if (isPainted()) {
            text.append("usemtl ").append(paint.name()).append('\n');
          }
          for (Vector3d p : shape.points()) {
            text.append("v ").append(Numbers.text(p.x()));
            text.append(' ').append(Numbers.text(p.y()));
            text.append(' ').append(Numbers.text(p.z())).append('\n');
          }
          for (int[] face : shape.faces()) {
            text.append('f');
            for (int corner : face) {
              text.append(' ').append(corner + before[0]);
            }
            text.append('\n');
          }
          before[0] += shape.points().size();
        });
    return text.toString();
  }

  /** Returns the text of the MTL file, empty if the model is not painted. */
  String mtl() {
    StringBuilder text = new StringBuilder();
    if (isPainted()) {
      for (Paint paint : parts.keySet()) {
        text.append("newmtl ").append(paint.name()).append('\n');
        text.append(paint.lines()).append('\n');
      }
    }
    return text.toString();
  }

  private boolean isPainted() {
    return parts.keySet().stream().anyMatch(paint -> !paint.name().isEmpty());
  }
}

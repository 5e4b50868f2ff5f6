package glint.io;

import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Mapping;
import glint.io.YamlNode.Scalar;
import glint.io.YamlNode.Sequence;
import glint.math.Check;
import glint.math.Quaternion;
import glint.math.Transform;
import glint.math.Vector3d;
import java.util.List;
import java.util.function.Supplier;

/** Reads where a surface stands: scale, rotate, translate in this order, or a list in its own. */
final class TransformReader {

  private static final List<String> ORDER = List.of("scale", "rotate", "translate");

  private final Values values;

  TransformReader(Values values) {
    this.values = values;
  }

  /** Returns the product of a surface's transforms; with problems reported, of what is sound. */
  Transform read(Fields f) {
    Transform product = Transform.IDENTITY;
    for (String name : ORDER) {
      if (f.has(name)) {
        product = append(product, name, f.get(name));
      }
    }
    if (!f.has("transform")) {
      return product;
    }
    YamlNode list = f.get("transform");
    if (ORDER.stream().anyMatch(f::has)) {
      values.report(list, "give either 'transform' or 'scale', 'rotate' and 'translate'");
    }
    for (YamlNode item : values.list(list, "transforms")) {
      Entry step = Fields.kind(item, Section.STEP, values);
      if (step != null) {
        product = append(product, ((Scalar) step.key()).text(), step.value());
      }
    }
    return product;
  }

  private Transform append(Transform product, String name, YamlNode node) {
    long before = values.problems().reports();
    Supplier<Transform> step =
        switch (name) {
          case "scale" -> scale(node);
          case "rotate" -> rotate(node);
          case "translate" -> translate(node);
          default -> matrix(node);
        };
    if (values.problems().reports() != before) {
      return product;
    }
    Transform next =
        values.checked(
            node,
            () -> {
              Transform all = product.then(step.get());
              requireUsable(all);
              return all;
            });
    return next == null ? product : next;
  }

  private Supplier<Transform> scale(YamlNode node) {
    boolean one = node instanceof Scalar;
    double factor = one ? values.number(node) : 0;
    Vector3d factors = one ? new Vector3d(factor, factor, factor) : values.vector(node);
    return () -> {
      Check.finite("scale", factors);
      return Transform.scale(factors);
    };
  }

  private Supplier<Transform> rotate(YamlNode node) {
    Supplier<Quaternion> turn = node instanceof Mapping ? turn(node) : quaternion(node);
    return () -> Transform.rotate(turn.get());
  }

  private Supplier<Quaternion> quaternion(YamlNode node) {
    List<Double> q = values.numbers(node, 4, "[w, x, y, z] or {axis, degrees}");
    return () -> new Quaternion(q.get(0), q.get(1), q.get(2), q.get(3));
  }

  private Supplier<Quaternion> turn(YamlNode node) {
    Fields f = new Fields(node, Section.ROTATION, values);
    boolean euler = f.means("euler");
    boolean look = f.means("look") || f.has("up");
    boolean axis = f.has("axis") || f.has("degrees");
    if (euler && look || euler && axis || look && axis) {
      values.report(
          node, "a rotation has either 'axis' and 'degrees', or 'euler', or 'look' and 'up'");
    }
    if (euler) {
      Vector3d degrees = f.vector("euler");
      return () -> Quaternion.euler(degrees.x(), degrees.y(), degrees.z());
    }
    if (look) {
      Vector3d forward = f.vector("look");
      Vector3d up = f.has("up") ? f.vector("up") : new Vector3d(0, 1, 0);
      return () -> {
        Check.direction("look", forward);
        Check.direction("up", up);
        return Quaternion.looking(forward, up);
      };
    }
    Vector3d about = f.vector("axis");
    double degrees = f.number("degrees");
    return () -> {
      Check.direction("axis", about);
      return Quaternion.aboutAxis(about, degrees);
    };
  }

  private Supplier<Transform> translate(YamlNode node) {
    Vector3d offset = values.vector(node);
    return () -> {
      Check.finite("translate", offset);
      return Transform.translate(offset);
    };
  }

  private Supplier<Transform> matrix(YamlNode node) {
    double[] rows = new double[12];
    if (node instanceof Sequence list && list.items().size() == 3) {
      for (int i = 0; i < 12; i++) {
        rows[i] = values.numbers(list.items().get(i / 4), 4, "[x, y, z, offset]").get(i % 4);
      }
    } else {
      values.wrong(node, "3 rows of 4 numbers [x, y, z, offset]");
    }
    return () -> {
      for (int i = 0; i < 4; i++) {
        Check.finite("matrix", new Vector3d(rows[i], rows[4 + i], rows[8 + i]));
      }
      return Transform.matrix(rows);
    };
  }

  /**
   * Checks that a product of transforms and its inverse kept finite numbers.
   *
   * @throws ArithmeticException if they did not
   */
  static void requireUsable(Transform product) {
    if (!isFinite(product.rows()) || !isFinite(product.inverted().rows())) {
      throw new ArithmeticException("the transforms up to here leave the range of numbers");
    }
  }

  private static boolean isFinite(double[] rows) {
    for (double v : rows) {
      if (!Double.isFinite(v)) {
        return false;
      }
    }
    return true;
  }
}

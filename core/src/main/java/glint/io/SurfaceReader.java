package glint.io;

import glint.geometry.Box;
import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Pyramid;
import glint.geometry.Quad;
import glint.geometry.Sphere;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.io.YamlNode.Entry;
import glint.io.YamlNode.Scalar;
import glint.io.YamlNode.Sequence;
import glint.math.Check;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.ImageTexture;
import glint.optics.Material;
import glint.optics.Texture;
import glint.scene.NamedMaterial;
import glint.scene.Placement;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Reads surfaces with their materials and transforms. */
final class SurfaceReader {

  private final Values values;
  private final MaterialReader materials;
  private final Models models;
  private final Map<List<NamedMaterial>, List<NamedMaterial>> lists = new HashMap<>();
  private final TransformReader transforms;

  SurfaceReader(MaterialReader materials, Models models, Values values) {
    this.values = values;
    this.materials = materials;
    this.models = models;
    transforms = new TransformReader(values);
  }

  /** Returns the surface of one list item at its place, or null with its problems reported. */
  Placement read(YamlNode item) {
    Entry entry = Fields.kind(item, Section.SURFACE, values);
    if (entry == null) {
      return null;
    }
    String kind = ((Scalar) entry.key()).text();
    Section section = Section.valueOf(kind.toUpperCase(Locale.ROOT));
    Fields f = new Fields(entry.value(), section, values);
    Surface surface = shape(section, f);
    Material material = materials.of(f);
    boolean sound = surface != null && material != null;
    List<NamedMaterial> made = sound ? shared(madeOf(f, surface, material)) : List.of();
    Transform toWorld = transforms.read(f);
    int line = entry.key().place().line();
    Vector3d motion = f.has("motion") ? f.vector("motion") : Vector3d.ZERO;
    return f.build(() -> new Placement(surface, toWorld, made, motion, line));
  }

  /** A material that is written is for all of a surface; without one a model keeps its own. */
  private List<NamedMaterial> madeOf(Fields f, Surface surface, Material material) {
    String name = f.get("material") instanceof Scalar named ? named.text() : "";
    List<NamedMaterial> made = List.of(new NamedMaterial(name, material));
    if (surface instanceof Mesh mesh) {
      made = f.has("material") ? made : models.materials(f.get("file"), material);
      if (made != null && !mesh.hasTexturePoints()) {
        noteImages(f, made);
      }
    }
    return made;
  }

  /** Tells that images lie on a model without texture points, which then show one colour. */
  private void noteImages(Fields f, List<NamedMaterial> made) {
    for (NamedMaterial each : made) {
      Texture texture = each.material().texture().orElse(null);
      if (texture instanceof ImageTexture image && !image.mapping().isPresent()) {
        values.note(
            f.get("file"),
            "the model has no texture points, so that its image shows one colour;"
                + " a texture may have a 'mapping'");
        return;
      }
    }
  }

  /** Returns the one list for all surfaces that are made of the same, or null for null. */
  private List<NamedMaterial> shared(List<NamedMaterial> made) {
    return made == null ? null : lists.computeIfAbsent(made, List::copyOf);
  }

  private Surface shape(Section section, Fields f) {
    return switch (section) {
      case SPHERE -> sphere(f);
      case TRIANGLE -> triangle(f);
      case PLANE -> plane(f);
      case QUAD -> quad(f);
      case BOX -> box(f);
      case PYRAMID -> pyramid(f);
      case CYLINDER -> cylinder(f, false);
      case CONE -> cylinder(f, true);
      case MESH -> models.mesh(f.need("file"), f.get("smooth"));
      default -> throw new IllegalArgumentException(section + " is no surface");
    };
  }

  private static Surface sphere(Fields f) {
    Vector3d center = f.vector("center");
    double radius = f.number("radius");
    return f.build(() -> new Sphere(center, radius));
  }

  private Surface triangle(Fields f) {
    List<Vector3d> v = points(f.need("vertices"), 3);
    return f.build(() -> new Triangle(v.get(0), v.get(1), v.get(2)));
  }

  private static Surface plane(Fields f) {
    Vector3d point = f.vector("point");
    Vector3d normal = f.vector("normal");
    return f.build(() -> new Plane(point, normal));
  }

  private static Surface quad(Fields f) {
    Vector3d corner = f.vector("corner");
    Vector3d edge1 = f.vector("edge1");
    Vector3d edge2 = f.vector("edge2");
    return f.build(() -> new Quad(corner, edge1, edge2));
  }

  private static Surface box(Fields f) {
    Vector3d min = f.vector("min");
    Vector3d max = f.vector("max");
    return f.build(() -> new Box(min, max));
  }

  private Surface pyramid(Fields f) {
    Vector3d apex = f.vector("apex");
    List<Vector3d> base = points(f.need("base"), 4);
    return f.build(() -> new Pyramid(apex, base));
  }

  /** A cylinder is as wide at its top as at its base unless it says otherwise; a cone has a tip. */
  private static Surface cylinder(Fields f, boolean cone) {
    Vector3d base = f.vector("base");
    Vector3d top = f.vector("top");
    double radius = f.number("radius");
    double topRadius = f.number("top_radius", cone ? 0 : radius);
    boolean capped = f.flag("capped", true);
    return f.build(() -> new Cylinder(base, top, radius, topRadius, capped));
  }

  private List<Vector3d> points(YamlNode node, int count) {
    if (node == null) {
      return Collections.nCopies(count, Vector3d.ZERO);
    }
    if (!(node instanceof Sequence list && list.items().size() == count)) {
      values.wrong(node, "a list of " + count + " points [x, y, z]");
      return Collections.nCopies(count, Vector3d.ZERO);
    }
    List<Vector3d> points = new ArrayList<>();
    for (YamlNode item : list.items()) {
      Vector3d point = values.vector(item);
      values.checked(
          item,
          () -> {
            Check.finite("corner", point);
            return point;
          });
      points.add(point);
    }
    return points;
  }
}

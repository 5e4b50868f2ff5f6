package glint.trace;

import glint.color.Rgb;
import glint.geometry.Hit;
import glint.geometry.Ray;
import glint.light.LightSample;
import glint.math.Vector3d;
import glint.optics.Medium;
import glint.trace.RayTree.Crossing;
import glint.trace.RayTree.Cut;
import glint.trace.RayTree.Fate;
import glint.trace.RayTree.Kind;
import glint.trace.RayTree.Lighting;
import glint.trace.RayTree.Meeting;
import glint.trace.RayTree.Sight;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Writes down what a tracer does with one camera ray, while it does it.
 *
 * <p>A tracer that was given none has nothing to tell, and asks at a bounce whether it has.
 */
public final class Recorder {

  /** A ray while it is followed. */
  private static final class Node {
    final int number;
    final Node parent;
    final Kind kind;
    final int bounces;
    final Vector3d origin;
    final Vector3d direction;
    final Rgb weight;
    final Frame frame;
    final List<Meeting> passed = new ArrayList<>();
    final List<Lighting> lights = new ArrayList<>();
    final List<Cut> cuts = new ArrayList<>();
    Meeting met;
    Rgb pattern = Rgb.WHITE;
    Rgb own;
    Sight sight;
    OptionalInt lamp = OptionalInt.empty();

    Node(int number, Node parent, Kind kind, int bounces, Frame frame) {
      this.number = number;
      this.parent = parent;
      this.kind = kind;
      this.bounces = bounces;
      this.frame = frame;
      origin = new Vector3d(frame.ray.ox, frame.ray.oy, frame.ray.oz);
      direction = new Vector3d(frame.ray.dx, frame.ray.dy, frame.ray.dz);
      weight = weight(frame);
    }

    RayTree tree(List<RayTree> children) {
      int from = parent == null ? 0 : parent.number;
      Optional<Meeting> end = Optional.ofNullable(met);
      return new RayTree(
          number, from, kind, bounces, origin, direction, weight, passed, end, lamp, sight, cuts,
          children);
    }
  }

  /** All rays of the tree, in the order in which they are followed; the last one is at work. */
  private final List<Node> rays = new ArrayList<>();

  /** The last ray of every level of the recursion. */
  private final List<Node> levels = new ArrayList<>();

  private final List<Crossing> crossings = new ArrayList<>();

  /** Forgets all, for another camera ray. */
  public void begin() {
    rays.clear();
    levels.clear();
    crossings.clear();
  }

  /**
   * A ray is followed.
   *
   * @param level its level of the recursion
   * @param mirrored whether it is the mirror image of the last one of its level
   */
  void follows(Frame frame, int level, int bounces, boolean mirrored) {
    if (level == 0 && !mirrored) {
      rays.clear();
      levels.clear();
    }
    while (levels.size() <= level) {
      levels.add(null);
    }
    Node parent = mirrored ? levels.get(level) : level == 0 ? null : levels.get(level - 1);
    Kind kind =
        mirrored ? Kind.REFLECTION : parent == null ? Kind.CAMERA : through(parent, bounces);
    Node node = new Node(rays.size() + 1, parent, kind, bounces, frame);
    rays.add(node);
    levels.set(level, node);
  }

  /** What goes straight through counts as no bounce. */
  private static Kind through(Node parent, int bounces) {
    return bounces == parent.bounces ? Kind.STRAIGHT : Kind.REFRACTION;
  }

  /**
   * The ray meets a surface.
   *
   * @param beyond the medium on the other side; not asked for if the surface is opaque
   */
  void meets(Ray ray, Hit hit, Boundary boundary, Medium before, Medium beyond) {
    Vector3d normal = new Vector3d(hit.nx, hit.ny, hit.nz);
    Vector3d shading = new Vector3d(hit.sx, hit.sy, hit.sz);
    double cos = -(ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz);
    Optional<RayTree.Boundary> way =
        boundary.opaque
            ? Optional.empty()
            : Optional.of(new RayTree.Boundary(beyond, boundary.eta, 0));
    Meeting meeting =
        new Meeting(
            boundary.surface,
            boundary.several,
            hit.t,
            point(hit),
            normal,
            shading,
            cos,
            before,
            way);
    if (boundary.opaque || boundary.visible) {
      last().met = meeting;
    } else {
      last().passed.add(meeting);
    }
  }

  /** The ray ends at a light of the scene that has an area. */
  void meets(int light) {
    last().lamp = OptionalInt.of(light);
  }

  /** The boundary that the ray meets reflects a share of it. */
  void splits(double reflected) {
    Meeting m = last().met;
    RayTree.Boundary way = m.boundary().get();
    way = new RayTree.Boundary(way.beyond(), way.eta(), reflected);
    last().met =
        new Meeting(
            m.surface(),
            m.several(),
            m.t(),
            m.point(),
            m.normal(),
            m.shading(),
            m.cos(),
            m.before(),
            Optional.of(way));
  }

  /** The surface, of a colour with this pattern, gives so much, whether lit or not. */
  void glows(Rgb pattern, double r, double g, double b) {
    last().pattern = pattern;
    last().own = new Rgb(r, g, b);
  }

  /** The way to a light leads through a surface, or ends at it. */
  void crosses(Hit hit, int surface, double reflected, Rgb passing) {
    crossings.add(new Crossing(surface, point(hit), reflected, passing));
  }

  /** A light is done with: it adds what is given here. */
  void lights(int number, Fate fate, LightSample sample, double cos, Rgb passing, Rgb added) {
    Vector3d towards =
        fate == Fate.DARK ? Vector3d.ZERO : new Vector3d(sample.lx, sample.ly, sample.lz);
    Rgb share = fate == Fate.LIT ? passing : Rgb.BLACK;
    List<Crossing> way = List.copyOf(crossings);
    last().lights.add(new Lighting(number, fate, towards, cos, way, share, added));
    crossings.clear();
  }

  /** The ray's end is seen. */
  void sees(Frame frame, double r, double g, double b) {
    Node node = last();
    Rgb radiance = new Rgb(r, g, b);
    Rgb own = node.met == null ? radiance : node.own;
    node.sight = new Sight(weight(frame), node.pattern, own, List.copyOf(node.lights), radiance);
  }

  /** Something that could come of the ray is not followed, and this much may be missing. */
  void cuts(Frame frame, int bounces, RayTree.Reason reason, double missing) {
    Node node = last();
    Kind kind = frame == node.frame ? Kind.REFLECTION : through(node, bounces);
    node.cuts.add(new Cut(kind, reason, weight(frame), missing));
  }

  /** Returns what became of the last camera ray. */
  public RayTree tree() {
    List<List<RayTree>> children = new ArrayList<>();
    rays.forEach(ray -> children.add(new ArrayList<>()));
    // A ray comes after its parent: from the end on, all children of each are there.
    for (int i = rays.size() - 1; i > 0; i--) {
      Node ray = rays.get(i);
      children.get(ray.parent.number - 1).add(0, ray.tree(children.get(i)));
    }
    return rays.get(0).tree(children.get(0));
  }

  private Node last() {
    return rays.get(rays.size() - 1);
  }

  private static Rgb weight(Frame frame) {
    return new Rgb(frame.weightR, frame.weightG, frame.weightB);
  }

  private static Vector3d point(Hit hit) {
    return new Vector3d(hit.px, hit.py, hit.pz);
  }
}

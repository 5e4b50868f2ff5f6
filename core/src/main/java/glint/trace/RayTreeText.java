package glint.trace;

import glint.color.Rgb;
import glint.math.Vector3d;
import glint.optics.Medium;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.trace.RayTree.Boundary;
import glint.trace.RayTree.Crossing;
import glint.trace.RayTree.Cut;
import glint.trace.RayTree.Fate;
import glint.trace.RayTree.Kind;
import glint.trace.RayTree.Lighting;
import glint.trace.RayTree.Meeting;
import glint.trace.RayTree.Reason;
import glint.trace.RayTree.Sight;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Writes a ray tree for people, in lines.
 *
 * <p>What adds up to the sample stands there with all its digits, everything else with six.
 * Surfaces and lights have the numbers of their places in the scene, from 0.
 */
public final class RayTreeText {

  /** Deeper rays are indented no more: each names the ray that it comes of. */
  private static final int DEEPEST = 16;

  private static final MathContext DIGITS = new MathContext(6);

  private final Prepared scene;
  private final List<String> lines = new ArrayList<>();
  private String indent = "";

  private RayTreeText(Prepared scene) {
    this.scene = scene;
  }

  /** Returns what tells of a tree of a scene. */
  public static List<String> of(Prepared scene, RayTree tree) {
    RayTreeText text = new RayTreeText(scene);
    List<RayTree> rays = tree.rays();
    int[] depths = new int[rays.size() + 1];
    for (RayTree ray : rays) {
      depths[ray.number()] = depths[ray.parent()] + 1;
      StringBuilder indent = new StringBuilder();
      for (int i = 1; i < Math.min(depths[ray.number()], DEEPEST); i++) {
        indent.append("  ");
      }
      text.indent = indent.toString();
      text.ray(ray);
    }
    text.indent = "";
    String count = rays.size() == 1 ? "the ray gives" : rays.size() + " rays add up to";
    text.line(count + " " + tree.radiance());
    return text.lines;
  }

  /** Returns what tells of one ray of a tree, without those that came of it. */
  public static List<String> ofRay(Prepared scene, RayTree ray) {
    RayTreeText text = new RayTreeText(scene);
    text.ray(ray);
    return text.lines;
  }

  private void ray(RayTree ray) {
    boolean camera = ray.parent() == 0;
    line(
        "ray " + ray.number() + ": " + word(ray.kind()),
        camera ? "" : "of ray " + ray.parent(),
        camera ? "" : "bounce " + ray.bounces(),
        "from " + point(ray.origin()),
        "along " + point(ray.direction()),
        "weight " + color(ray.weight()));
    indent += "  ";
    ray.passed().forEach(hidden -> meeting("passes unseen ", hidden));
    ray.met().ifPresent(met -> meeting("meets ", met));
    Sight sight = ray.sight();
    if (!sight.pattern().equals(Rgb.WHITE)) {
      line("texture " + color(sight.pattern()));
    }
    sight.lights().forEach(this::light);
    line(source(ray) + color(sight.own()));
    line(
        "gives " + color(sight.radiance()) + " at weight " + color(sight.weight()),
        "which adds " + sight.contribution());
    ray.cuts().forEach(this::cut);
  }

  private String source(RayTree ray) {
    if (ray.lamp().isPresent()) {
      return "meets " + light(ray.lamp().getAsInt()) + ": ";
    }
    return ray.met().isPresent() ? "own light " : "meets nothing: background ";
  }

  private void meeting(String verb, Meeting m) {
    line(
        verb + surface(m.surface()) + (m.several() ? " and what coincides with it" : ""),
        "at t " + number(m.t()),
        "point " + point(m.point()),
        "normal " + point(m.normal()),
        m.shading().equals(m.normal()) ? "" : "shading normal " + point(m.shading()),
        "cos " + number(m.cos()));
    if (m.boundary().isPresent()) {
      Boundary way = m.boundary().get();
      line(
          "from " + medium(m.before()) + " into " + medium(way.beyond()),
          "index ratio " + number(way.eta()),
          "Fresnel reflects " + number(way.reflected()));
    }
  }

  private void light(Lighting l) {
    String name = light(l.light());
    String cos = "cos " + number(l.cos());
    switch (l.fate()) {
      case LIT -> line(name + " is seen", cos, "adds " + color(l.added()));
      case SHADOWED -> line(name + " is shadowed", cos);
      case BEHIND -> line(name + " is behind the surface", cos);
      case DARK -> line(name + " sends nothing here");
    }
    for (Crossing c : l.crossings()) {
      String where = surface(c.surface()) + " at " + point(c.point());
      if (c.passing().isBlack()) {
        line("  by " + where);
      } else {
        String reflected = "Fresnel reflects " + number(c.reflected());
        line("  through " + where, reflected, color(c.passing()) + " is left");
      }
    }
    if (l.fate() == Fate.LIT && !l.crossings().isEmpty()) {
      line("  in all " + color(l.passing()) + " of it passes");
    }
  }

  private String light(int number) {
    return "light " + number + " (" + word(scene.scene().lights().get(number).getClass()) + ")";
  }

  private void cut(Cut c) {
    line(
        "no " + word(c.kind()) + ": " + (c.reason() == Reason.DEPTH ? "too deep" : "too little"),
        "weight " + color(c.weight()),
        Double.isFinite(c.missing())
            ? "at most " + number(c.missing()) + " is missing"
            : "what is missing has no bound");
  }

  private String surface(int number) {
    int place = scene.place(number);
    Placement p = scene.scene().placements().get(place);
    String what = word(p.surface().getClass());
    String material = scene.materialName(number);
    String name = material.isEmpty() ? "" : " of " + material;
    String line = p.line() == 0 ? "" : ", line " + p.line();
    return "surface " + place + " (" + what + name + line + ")";
  }

  private static String medium(Medium m) {
    if (m.equals(Medium.VACUUM)) {
      return "vacuum";
    }
    String absorption = m.absorbs() ? " and absorption " + color(m.absorption()) : "";
    String priority = m.priority() == 0 ? "" : " (priority " + m.priority() + ")";
    return "ior " + number(m.ior()) + absorption + priority;
  }

  private void line(String... parts) {
    StringBuilder line = new StringBuilder(indent).append(parts[0]);
    for (int i = 1; i < parts.length; i++) {
      line.append(parts[i].isEmpty() ? "" : ", ").append(parts[i]);
    }
    lines.add(line.toString());
  }

  private static String word(Class<?> kind) {
    return kind.getSimpleName().toLowerCase(Locale.ROOT);
  }

  private static String word(RayTree.Kind kind) {
    return kind == Kind.STRAIGHT ? "straight on" : kind.name().toLowerCase(Locale.ROOT);
  }

  private static String point(Vector3d v) {
    return "(" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
  }

  private static String color(Rgb c) {
    String r = number(c.r());
    String g = number(c.g());
    String b = number(c.b());
    return r.equals(g) && g.equals(b) ? r : "(" + r + ", " + g + ", " + b + ")";
  }

  private static String number(double x) {
    if (!Double.isFinite(x)) {
      return Double.toString(x);
    }
    BigDecimal rounded = new BigDecimal(x).round(DIGITS).stripTrailingZeros();
    int magnitude = rounded.precision() - rounded.scale();
    return magnitude < -3 || magnitude > 9 ? rounded.toString() : rounded.toPlainString();
  }
}

package glint.scene;

import glint.geometry.Mesh;
import glint.geometry.Primitives;
import glint.light.Illumination;
import glint.optics.Highlight;
import glint.optics.ImageTexture;
import glint.optics.Material;
import glint.optics.Texture;
import java.util.List;
import java.util.function.Predicate;

/**
 * What a scene needs, and what is therefore left out; immutable.
 *
 * <p>These very decisions select the code that runs, and {@code glint plan} prints them.
 */
public record RenderPlan(
    Decision lens,
    Decision motion,
    Decision instances,
    Decision tree,
    Decision pencils,
    Decision smoothNormals,
    Decision directLight,
    Decision lamps,
    Decision shadows,
    Decision textures,
    Decision images,
    Decision highlights,
    Decision mirrors,
    Decision gloss,
    Decision refraction,
    Decision sky) {

  /** Up to this many bounded primitives a scan of all is faster than a walk through a tree. */
  private static final int HANDFUL = 8;

  private static final Predicate<Texture> IMAGE = t -> t instanceof ImageTexture;

  /** Looks at a scene once and decides. */
  static RenderPlan of(
      Scene scene, Decision instances, Primitives primitives, Illumination lights) {
    return new RenderPlan(
        lens(scene),
        motion(scene),
        instances,
        tree(primitives),
        Pencils.decide(scene, lights, primitives),
        smoothNormals(scene),
        directLight(scene, lights),
        lamps(lights),
        shadows(scene, lights),
        textures(scene),
        images(scene),
        highlights(scene, lights),
        mirrors(scene),
        gloss(scene),
        refraction(scene),
        sky(scene));
  }

  /** Returns a plan that uses everything, whether needed or not: the yardstick of the others. */
  public static RenderPlan everything() {
    String reason = "everything is switched on";
    return new RenderPlan(
        new Decision("lens", true, reason),
        new Decision("motion", true, reason),
        new Decision("instances", true, reason),
        new Decision("hierarchy", true, reason),
        new Decision("pencils", true, reason),
        new Decision("smooth normals", true, reason),
        new Decision("direct light", true, reason),
        new Decision("area lights", true, reason),
        new Decision("shadow rays", true, reason),
        new Decision("textures", true, reason),
        new Decision("images", true, reason),
        new Decision("highlights", true, reason),
        new Decision("mirror rays", true, reason),
        new Decision("gloss", true, reason),
        new Decision("refraction", true, reason),
        new Decision("sky gradient", true, reason));
  }

  /** Returns the decisions in the order in which a ray meets them. */
  public List<Decision> decisions() {
    return List.of(
        lens,
        motion,
        instances,
        tree,
        pencils,
        smoothNormals,
        directLight,
        lamps,
        shadows,
        textures,
        images,
        highlights,
        mirrors,
        gloss,
        refraction,
        sky);
  }

  private static Decision motion(Scene scene) {
    int moving = count(scene, Placement::isMoving);
    return moving == 0
        ? new Decision("motion", false, "nothing moves while the shutter is open")
        : new Decision("motion", true, "rays have random times; surfaces that move: " + moving);
  }

  static Decision lens(Scene scene) {
    return scene.camera().lens().filter(lens -> lens.radius() > 0).isPresent()
        ? new Decision("lens", true, "rays start at random places of it")
        : new Decision("lens", false, "the camera is a pinhole: everything is sharp");
  }

  /** Decides whether meshes that stand at several places are kept once. */
  static Decision instances(Scene scene) {
    SharedMeshes shared = new SharedMeshes(scene);
    int places = count(scene, shared::isInstance);
    String which =
        places == 0
            ? "no mesh stands at several places"
            : "meshes kept once, in their own space: " + shared.count() + "; places: " + places;
    return new Decision("instances", places > 0, which);
  }

  private static Decision tree(Primitives primitives) {
    int bounded = primitives.count() - primitives.unbounded();
    String counts = bounded + " bounded primitives, " + primitives.unbounded() + " without bounds";
    return bounded > HANDFUL || !primitives.models().isEmpty()
        ? new Decision("hierarchy", true, "bounding volumes over " + counts)
        : new Decision("hierarchy", false, "a handful is scanned: " + counts);
  }

  private static Decision smoothNormals(Scene scene) {
    int smooth = count(scene, p -> p.surface() instanceof Mesh mesh && mesh.isSmooth());
    String which =
        smooth == 0 ? "no mesh has normals of its own" : "meshes with normals: " + smooth;
    return new Decision("smooth normals", smooth > 0, which);
  }

  private static Decision directLight(Scene scene, Illumination lights) {
    String feature = "direct light";
    if (lights.count() == 0) {
      return new Decision(feature, false, "no light but ambient light");
    }
    int lit = count(scene, p -> p.any(RenderPlan::answersLights));
    if (lit == 0) {
      return new Decision(feature, false, "no surface is diffuse or has a highlight");
    }
    return new Decision(
        feature,
        true,
        lights.count() + " of its lights have a place or direction; surfaces lit: " + lit);
  }

  private static Decision lamps(Illumination lights) {
    String feature = "area lights";
    return lights.lamps() == 0
        ? new Decision(feature, false, "no light is a sphere or a rectangle")
        : new Decision(
            feature, true, "seen by rays, and a random place of each lights: " + lights.lamps());
  }

  static Decision shadows(Scene scene, Illumination lights) {
    String feature = "shadow rays";
    Decision light = directLight(scene, lights);
    if (!light.used()) {
      return new Decision(feature, false, light.reason());
    }
    boolean opaque = scene.placements().stream().noneMatch(p -> p.any(Material::isTransparent));
    String how =
        opaque
            ? "opaque surfaces only: any hit before the light ends the search"
            : "coloured: all transparent surfaces on the way to the light are walked through";
    return new Decision(feature, true, how);
  }

  private static Decision textures(Scene scene) {
    int textured = count(scene, p -> p.any(m -> m.texture().isPresent()));
    return textured == 0
        ? new Decision("textures", false, "every material has one colour")
        : new Decision("textures", true, "textured surfaces: " + textured);
  }

  private static Decision images(Scene scene) {
    int count = count(scene, p -> p.any(m -> m.texture().filter(IMAGE).isPresent()));
    return count == 0
        ? new Decision("images", false, "no texture is an image")
        : new Decision("images", true, "surfaces that show one: " + count);
  }

  private static Decision highlights(Scene scene, Illumination lights) {
    String feature = "highlights";
    Decision light = directLight(scene, lights);
    int shiny = count(scene, p -> p.any(m -> !m.specular().isBlack()));
    if (!light.used() || shiny == 0) {
      String reason = light.used() ? "no material is specular" : light.reason();
      return new Decision(feature, false, reason);
    }
    String model = scene.highlight() == Highlight.BLINN ? "Blinn n·h" : "Phong r·v";
    return new Decision(feature, true, model + "; specular surfaces: " + shiny);
  }

  private static Decision mirrors(Scene scene) {
    String feature = "mirror rays";
    int mirrors = count(scene, p -> p.any(m -> !m.reflection().isBlack()));
    if (mirrors == 0) {
      return new Decision(feature, false, "no material reflects");
    }
    return new Decision(feature, true, "reflecting surfaces: " + mirrors);
  }

  private static Decision gloss(Scene scene) {
    int glossy = count(scene, p -> p.any(Material::isGlossy));
    return glossy == 0
        ? new Decision("gloss", false, "what is mirrored is not spread")
        : new Decision("gloss", true, "mirror rays are random ones of a lobe; surfaces: " + glossy);
  }

  private static Decision refraction(Scene scene) {
    String feature = "refraction";
    int transparent = count(scene, p -> p.any(Material::isTransparent));
    if (transparent == 0) {
      return new Decision(feature, false, "no material is transparent: no interior stack either");
    }
    return new Decision(
        feature,
        true,
        "rays branch and keep a stack of media; transparent surfaces: " + transparent);
  }

  private static Decision sky(Scene scene) {
    boolean constant = scene.background().isConstant();
    return new Decision(
        "sky gradient", !constant, "the background is " + (constant ? "one colour" : "a gradient"));
  }

  private static boolean answersLights(Material m) {
    return !m.diffuse().isBlack() || !m.specular().isBlack();
  }

  private static int count(Scene scene, Predicate<Placement> which) {
    return (int) scene.placements().stream().filter(which).count();
  }
}

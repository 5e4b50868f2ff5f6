package glint.scene;

import glint.geometry.Cylinder;
import glint.geometry.Mesh;
import glint.geometry.Quad;
import glint.geometry.Surface;
import glint.geometry.Triangle;
import glint.optics.Material;
import glint.optics.Medium;
import glint.optics.Texture;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What the surfaces of a scene are made of, by their numbers; immutable. */
final class SurfaceTable {

  private final List<Placement> placements;

  /**
   * For each surface the number of its placement; empty if none is in parts, which are surfaces.
   */
  private final int[] place;

  private final Material[] materials;

  /** The textures of the surfaces, null where there is none; empty if no surface has one. */
  private final TexturedSurface[] textures;

  /** The different media of the scene. */
  private final List<Medium> media = new ArrayList<>();

  /** For each surface the number of its medium; empty if no light goes through any. */
  private final int[] mediumOf;

  /** For each surface that lets light through, or a part of which does, whether it is a sheet. */
  private final boolean[] open;

  SurfaceTable(List<Placement> placements, RenderPlan plan) {
    this.placements = placements;
    int count = placements.stream().mapToInt(p -> p.materials().size()).sum();
    place = new int[count > placements.size() ? count : 0];
    materials = new Material[count];
    textures = new TexturedSurface[plan.textures().used() ? count : 0];
    mediumOf = new int[plan.refraction().used() ? count : 0];
    open = new boolean[mediumOf.length];
    Known known = new Known(new HashMap<>(), new HashMap<>());
    int first = 0;
    for (int i = 0; i < placements.size(); i++) {
      first = number(i, first, known);
    }
  }

  /**
   * What is known of surfaces, of which many may stand at several places.
   *
   * @param closed whether a mesh is
   * @param textured surfaces with their textures
   */
  private record Known(
      Map<Mesh, Boolean> closed, Map<Surface, Map<Texture, TexturedSurface>> textured) {

    TexturedSurface textured(Surface surface, Texture texture) {
      return textured
          .computeIfAbsent(surface, any -> new HashMap<>())
          .computeIfAbsent(texture, any -> new TexturedSurface(surface, texture));
    }

    boolean isSheet(Surface surface) {
      return surface instanceof Triangle
          || surface instanceof Quad
          || (surface instanceof Cylinder c && !c.capped())
          || (surface instanceof Mesh m && !closed.computeIfAbsent(m, Mesh::isClosed));
    }
  }

  /** Numbers the surfaces of a placement from the first on; returns the number after its last. */
  private int number(int placement, int first, Known known) {
    Placement p = placements.get(placement);
    boolean sheet = p.any(Material::isTransparent) && known.isSheet(p.surface());
    int surface = first;
    for (NamedMaterial named : p.materials()) {
      Material material = named.material();
      if (place.length > 0) {
        place[surface] = placement;
      }
      materials[surface] = material;
      if (textures.length > 0 && material.texture().isPresent()) {
        textures[surface] = known.textured(p.surface(), material.texture().get());
      }
      if (mediumOf.length > 0) {
        mediumOf[surface] = mediumNumber(material);
        open[surface] = sheet;
      }
      surface++;
    }
    return surface;
  }

  private int mediumNumber(Material material) {
    Medium interior = material.interior();
    if (!material.isTransparent() || interior.isVacuum()) {
      return Prepared.OUTSIDE;
    }
    if (!media.contains(interior)) {
      media.add(interior);
    }
    return media.indexOf(interior);
  }

  int count() {
    return materials.length;
  }

  /** Returns the number of the placement that a surface is, or is a part of. */
  int place(int surface) {
    return place.length > 0 ? place[surface] : surface;
  }

  Placement placement(int surface) {
    return placements.get(place(surface));
  }

  Material material(int surface) {
    return materials[surface];
  }

  String materialName(int surface) {
    int part = 0;
    while (part < surface && place(surface - part - 1) == place(surface)) {
      part++;
    }
    return placement(surface).materials().get(part).name();
  }

  /** Returns a surface's texture, or null if it has none. */
  TexturedSurface texture(int surface) {
    return textures.length > 0 ? textures[surface] : null;
  }

  int mediumOf(int surface) {
    return mediumOf[surface];
  }

  boolean isOpen(int surface) {
    return open[surface];
  }

  Medium medium(int number) {
    return media.get(number);
  }
}

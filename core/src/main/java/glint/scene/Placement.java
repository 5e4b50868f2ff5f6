package glint.scene;

import glint.geometry.Carried;
import glint.geometry.Mesh;
import glint.geometry.Surface;
import glint.math.Check;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import java.util.List;
import java.util.Objects;
import java.util.function.Predicate;

/**
 * A surface at its place in the world, made of a material; immutable.
 *
 * @param materials one for all of it, or one for each part of a mesh
 * @param motion how far it moves, evenly, while the shutter is open
 * @param line where in its file it is written, from 1, or 0
 */
public record Placement(
    Surface surface, Transform toWorld, List<NamedMaterial> materials, Vector3d motion, int line) {

  /** Checks that nothing is missing. */
  public Placement {
    Objects.requireNonNull(surface, "surface");
    Objects.requireNonNull(toWorld, "toWorld");
    materials = List.copyOf(materials);
    int parts = surface instanceof Mesh mesh ? mesh.parts() : 1;
    if (materials.size() != 1 && materials.size() != parts) {
      throw new IllegalArgumentException("one material for all parts, or one for each");
    }
    Carried.check(surface, toWorld);
    Check.finite("motion", motion);
  }

  /** Places a surface that stands still. */
  public Placement(Surface surface, Transform toWorld, List<NamedMaterial> materials, int line) {
    this(surface, toWorld, materials, Vector3d.ZERO, line);
  }

  /** Places a surface that no file names. */
  public Placement(Surface surface, Transform toWorld, Material material) {
    this(surface, toWorld, List.of(new NamedMaterial("", material)), 0);
  }

  /** Places a surface where its own coordinates say. */
  public static Placement of(Surface surface, Material material) {
    return new Placement(surface, Transform.IDENTITY, material);
  }

  /** Returns the material of a surface that has but one, or of a mesh's first part. */
  public Material material() {
    return materials.get(0).material();
  }

  /** Returns the same surface, moving so far while the shutter is open. */
  public Placement moving(Vector3d way) {
    return new Placement(surface, toWorld, materials, way, line);
  }

  /** Returns whether it moves while the shutter is open. */
  public boolean isMoving() {
    return motion.maxAbs() > 0;
  }

  /** Returns whether any of its materials is such. */
  boolean any(Predicate<Material> which) {
    return materials.stream().anyMatch(named -> which.test(named.material()));
  }
}

package glint.fuzz;

import glint.geometry.Mesh;
import glint.light.Light;
import glint.math.Vector3d;
import glint.scene.Placement;
import glint.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A random scene, and the rays to try in it besides those of its camera.
 *
 * @param meshes the numbers of its meshes, which a mesh does not tell
 */
record FuzzScene(long seed, Scene scene, List<MeshNumbers> meshes, List<Segment> rays) {

  /** A ray's origin and a point that it passes. */
  record Segment(Vector3d from, Vector3d to) {}

  /** What a mesh was made of. */
  record MeshNumbers(Mesh mesh, double[] points, int[] corners) {}

  /** Returns the same without one of its surfaces and then lights. */
  FuzzScene without(int part) {
    List<Placement> placements = new ArrayList<>(scene.placements());
    List<Light> lights = new ArrayList<>(scene.lights());
    if (part < placements.size()) {
      placements.remove(part);
    } else {
      lights.remove(part - placements.size());
    }
    Scene less =
        new Scene(
            scene.name(),
            scene.title(),
            scene.width(),
            scene.height(),
            scene.camera(),
            scene.background(),
            lights,
            placements,
            scene.highlight(),
            scene.transfer(),
            scene.maxDepth(),
            scene.expectations(),
            scene.turntable());
    return new FuzzScene(seed, less, meshes, rays);
  }

  /** Returns the number of its surfaces and lights. */
  int parts() {
    return scene.placements().size() + scene.lights().size();
  }

  /** Prints everything, all numbers with all their digits. */
  @Override
  public String toString() {
    StringBuilder out = new StringBuilder();
    line(out, scene.camera());
    line(out, scene.background() + ", " + scene.highlight() + ", depth " + scene.maxDepth());
    scene.lights().forEach(light -> line(out, light));
    for (Placement p : scene.placements()) {
      line(out, p.surface() instanceof Mesh mesh ? numbers(mesh) : p.surface());
      if (!p.toWorld().isIdentity()) {
        line(out, "  under " + Arrays.toString(p.toWorld().rows()));
        line(out, "  and back " + Arrays.toString(p.toWorld().inverted().rows()));
      }
      line(out, "  of " + p.material());
    }
    return out.toString();
  }

  private String numbers(Mesh mesh) {
    for (MeshNumbers m : meshes) {
      if (m.mesh() == mesh) {
        return "Mesh[" + Arrays.toString(m.points()) + ", " + Arrays.toString(m.corners()) + "]";
      }
    }
    throw new IllegalArgumentException("not a mesh of this scene");
  }

  private static void line(StringBuilder out, Object what) {
    out.append(what).append('\n');
  }
}

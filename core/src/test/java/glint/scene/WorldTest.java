package glint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import glint.geometry.Primitives;
import glint.geometry.Sphere;
import glint.math.Vector3d;
import glint.optics.Material;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class WorldTest {

  private static Scene scene() {
    Scene.Builder scene =
        new Scene.Builder("balls")
            .size(16, 12)
            .camera(
                Camera.of(
                    new Vector3d(0, 0, 9),
                    Vector3d.ZERO,
                    new Vector3d(0, 1, 0),
                    Projection.vertical(40)));
    for (int i = 0; i < 2000; i++) {
      scene.place(Placement.of(new Sphere(new Vector3d(i, 0, 0), 1), Material.WHITE));
    }
    return scene.build();
  }

  @Test
  void threadsThatAskAtOnceShareWhatIsPreparedOnce() {
    Scene scene = scene();
    World world = new World(scene);
    assertSame(scene, world.scene());
    Set<Primitives> built =
        Collections.synchronizedSet(Collections.newSetFromMap(new IdentityHashMap<>()));
    IntStream.range(1, 9)
        .parallel()
        .forEach(
            i -> {
              Scene picture = scene.seenBy(scene.camera(), i, i);
              Prepared prepared = world.seenIn(picture);
              assertSame(picture, prepared.scene());
              built.add(prepared.primitives());
            });
    assertEquals(1, built.size());
  }

  @Test
  void aPictureOfAnotherWorldIsRefused() {
    World world = new World(scene());
    assertThrows(IllegalArgumentException.class, () -> world.seenIn(scene()));
  }
}

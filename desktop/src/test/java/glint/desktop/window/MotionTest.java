package glint.desktop.window;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.geometry.Sphere;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.render.Progress;
import glint.render.RenderSettings;
import glint.render.Renderer;
import glint.scene.Camera;
import glint.scene.Handheld;
import glint.scene.Placement;
import glint.scene.Prepared;
import glint.scene.Projection;
import glint.scene.Scene;
import glint.scene.World;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class MotionTest {

  private static final Scene SCENE = scene();

  private static Scene scene() {
    Vector3d eye = new Vector3d(0, 0, 9);
    Vector3d up = new Vector3d(0, 1, 0);
    return new Scene.Builder("ball")
        .size(161, 100)
        .camera(Camera.of(eye, Vector3d.ZERO, up, Projection.vertical(40)))
        .place(Placement.of(new Sphere(Vector3d.ZERO, 2), Material.WHITE))
        .build();
  }

  @Test
  void everyPictureIsWhatTheCameraSeesInAsManyPixelsAsThereIsTimeFor() throws Exception {
    BlockingQueue<Motion.Frame> frames = new ArrayBlockingQueue<>(9);
    Motion motion = new Motion(new World(SCENE), frames::add);
    motion.start();
    Camera camera = SCENE.camera();
    for (int i = 0; i < 5; i++) {
      camera = new Handheld(camera, 161, 100).orbited(80, 50, 90, 55);
      motion.show(camera);
      Motion.Frame frame = frames.poll(30, TimeUnit.SECONDS);
      assertSame(camera, frame.camera());
      int width = frame.picture().getWidth();
      int height = frame.picture().getHeight();
      assertTrue(i > 0 || width == 21 && height == 13, "one pixel for eight by eight at first");
      Scene picture = SCENE.seenBy(camera, width, height);
      RenderSettings one = RenderSettings.of(picture).sampled(1, 0);
      int[] expected =
          new Renderer(Prepared.of(picture), one)
              .render(Progress.NONE)
              .image()
              .toArgb(SCENE.transfer());
      assertArrayEquals(expected, frame.picture().getRGB(0, 0, width, height, null, 0, width));
    }
    motion.end();
    motion.show(SCENE.camera());
    assertEquals(null, frames.poll(50, TimeUnit.MILLISECONDS));
  }
}

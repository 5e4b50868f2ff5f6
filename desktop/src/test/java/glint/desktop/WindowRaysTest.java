package glint.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import glint.render.RenderSettings;
import glint.render.Replay;
import glint.scene.Prepared;
import glint.scene.Scene;
import glint.trace.RayTree;
import glint.trace.RayTreeText;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Looks into pixels in a real window. */
@Tag("window")
class WindowRaysTest {

  @TempDir private Path dir;

  @Test
  void aClickShowsTheRaysThatReplayTellsOfAndTheirWay() throws Exception {
    Path file = Scenes.write(dir.resolve("a.yaml"), "one");
    Scene scene = WindowTest.read(file).scenes().get(0).scene();
    try (OnScreen screen = new OnScreen(List.of(file), WindowTest::read)) {
      Component view = screen.part("picture", JComponent.class);
      JTree tree = screen.part("rays", JTree.class);
      screen.awaitStatus("done");
      screen.hands().key(KeyEvent.VK_1);
      int[] before = screen.middle(view, 40, 30);
      int left = (int) Math.rint((view.getWidth() - 40) / 2.0);
      int top = (int) Math.rint((view.getHeight() - 30) / 2.0);
      screen.hands().click(view, left + 17, top + 13);
      screen.await("the rays", () -> tree.getModel().getRoot() != null);
      RayTree rays = assertTells(tree, scene, 17, 13);
      assertTrue(rays.rays().size() > 1, "it meets the mirror");
      assertTrue(!Arrays.equals(before, screen.middle(view, 40, 30)), "their way is drawn");

      screen.hands().with(KeyEvent.VK_ALT, () -> screen.hands().key(KeyEvent.VK_RIGHT));
      screen.await("the next", () -> screen.text("rays of").contains("Pixel 18, 13"));
      assertTells(tree, scene, 18, 13);

      screen.hands().key(KeyEvent.VK_L);
      screen.await("nothing", () -> tree.getModel().getRoot() == null);
    }
  }

  /** Checks that a tree says all that replay does of a pixel; returns its rays. */
  private static RayTree assertTells(JTree tree, Scene scene, int column, int row) {
    Prepared prepared = Prepared.of(scene);
    RenderSettings one = RenderSettings.of(scene).sampled(1, 0);
    RayTree rays = new Replay(prepared, one, column, row).sample(0).tree();
    List<String> expected = new ArrayList<>();
    RayTreeText.of(prepared, rays).forEach(line -> expected.add(line.trim()));
    expected.remove(expected.size() - 1);
    List<String> actual =
        EventThread.on(
            () -> {
              List<String> words = new ArrayList<>();
              DefaultMutableTreeNode root = (DefaultMutableTreeNode) tree.getModel().getRoot();
              Collections.list(root.preorderEnumeration()).forEach(n -> words.add(n.toString()));
              return words;
            });
    assertEquals(sorted(expected), sorted(actual));
    return rays;
  }

  /** Returns all words in order: a line may stand in two nodes. */
  private static List<String> sorted(List<String> lines) {
    List<String> words = new ArrayList<>();
    lines.forEach(line -> words.addAll(List.of(line.replace(",", " ").trim().split(" +"))));
    Collections.sort(words);
    return words;
  }
}

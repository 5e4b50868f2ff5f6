package glint.desktop;

import glint.desktop.window.Desk;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JList;

/** Clicks, drags, types, picks scenes and edits files at random; opens a window that it closes. */
final class Monkey {

  /** Every key of the window but those that close it, and some that it does not know. */
  private static final String KEYS =
      "OFPENBXDMTRYJLIKQ1 " + (char) KeyEvent.VK_F6 + (char) KeyEvent.VK_F7 + (char) KeyEvent.VK_F1;

  private static final int[] MORE_KEYS = {
    KeyEvent.VK_ESCAPE,
    KeyEvent.VK_UP,
    KeyEvent.VK_DOWN,
    KeyEvent.VK_PAGE_UP,
    KeyEvent.VK_PAGE_DOWN,
    KeyEvent.VK_COMMA,
    KeyEvent.VK_PERIOD,
    KeyEvent.VK_MINUS,
    KeyEvent.VK_EQUALS,
    KeyEvent.VK_TAB,
    KeyEvent.VK_ENTER,
    KeyEvent.VK_F8,
    KeyEvent.VK_HOME
  };

  private final Random random;
  private final Desk desk;
  private final Path gallery;
  private final Path own;
  private final String good;
  private int steps;
  private int windows;

  Monkey(Path dir, Path gallery, Desk desk, long seed) throws Exception {
    this.desk = desk;
    this.gallery = gallery;
    random = new Random(seed);
    own = Scenes.write(dir.resolve("own.yaml"), "one", "two");
    good = Files.readString(own);
  }

  int steps() {
    return steps;
  }

  int windows() {
    return windows;
  }

  /** Works for some minutes. */
  void work(double minutes) throws Exception {
    long end = System.nanoTime() + (long) (minutes * 60e9);
    while (System.nanoTime() < end) {
      windows++;
      try (OnScreen screen = new OnScreen(List.of(gallery, own), desk)) {
        while (System.nanoTime() < end && screen.frame().isDisplayable()) {
          step(screen);
          steps++;
        }
      }
    }
  }

  private void step(OnScreen screen) throws Exception {
    dismiss();
    JFrame frame = screen.frame();
    int what = random.nextInt(100);
    if (what < 30) {
      screen.hands().robot().mouseMove(x(frame), y(frame));
      press(screen, random.nextInt(8) == 0 ? 2 : 1);
    } else if (what < 45) {
      drag(screen);
    } else if (what < 60) {
      key(screen);
    } else if (what < 75) {
      pick(screen);
    } else if (what < 85) {
      screen.hands().wheel(random.nextInt(7) - 3);
    } else if (what < 90) {
      Files.writeString(own, good.replace("radius: 1", "radius: " + random.nextInt(3)));
    } else if (what < 93) {
      screen.hands().drop(frame, List.of(own));
    } else if (what < 96) {
      Dimension size = new Dimension(300 + random.nextInt(1200), 200 + random.nextInt(800));
      EventThread.on(
          () -> {
            frame.setSize(size);
            return null;
          });
    } else {
      Thread.sleep(random.nextInt(3000));
    }
  }

  private void pick(OnScreen screen) {
    JList<?> list = screen.part("scenes", JList.class);
    EventThread.on(
        () -> {
          int count = list.getModel().getSize();
          list.setSelectedIndex(count == 0 ? -1 : random.nextInt(count));
          return null;
        });
  }

  private void key(OnScreen screen) {
    int kind = random.nextInt(10);
    if (kind == 0) {
      screen.hands().command("SCD".charAt(random.nextInt(3)));
    } else if (kind < 7) {
      screen.hands().key(KEYS.charAt(random.nextInt(KEYS.length())));
    } else {
      screen.hands().key(MORE_KEYS[random.nextInt(MORE_KEYS.length)]);
    }
  }

  private void drag(OnScreen screen) {
    JFrame frame = screen.frame();
    int button =
        random.nextInt(4) == 0 ? InputEvent.BUTTON3_DOWN_MASK : InputEvent.BUTTON1_DOWN_MASK;
    screen.hands().robot().mouseMove(x(frame), y(frame));
    screen.hands().robot().mousePress(button);
    for (int i = random.nextInt(6); i >= 0; i--) {
      screen.hands().robot().mouseMove(x(frame), y(frame));
    }
    screen.hands().robot().mouseRelease(button);
  }

  private static void press(OnScreen screen, int times) {
    for (int i = 0; i < times; i++) {
      screen.hands().robot().mousePress(InputEvent.BUTTON1_DOWN_MASK);
      screen.hands().robot().mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
  }

  private int x(Component frame) {
    return frame.getX() + random.nextInt(Math.max(1, frame.getWidth()));
  }

  private int y(Component frame) {
    return frame.getY() + random.nextInt(Math.max(1, frame.getHeight()));
  }

  /** Closes dialogs. */
  private static void dismiss() {
    EventThread.on(
        () -> {
          for (Window each : Window.getWindows()) {
            if (each instanceof JDialog && each.isShowing()) {
              each.dispose();
            }
          }
          return null;
        });
  }
}

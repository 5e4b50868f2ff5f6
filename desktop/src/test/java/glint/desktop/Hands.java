package glint.desktop;

import java.awt.Component;
import java.awt.Point;
import java.awt.Robot;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.TransferHandler;

/** What a person does with mouse and keyboard. */
final class Hands {

  private final Robot robot;

  /** Makes the hands of a robot. */
  Hands(Robot robot) {
    this.robot = robot;
  }

  Robot robot() {
    return robot;
  }

  /** Presses and lets go of a key. */
  void key(int code) {
    robot.keyPress(code);
    robot.keyRelease(code);
    robot.waitForIdle();
  }

  /** Presses a key while the one is held that goes with commands. */
  void command(int code) {
    int control = KeyEvent.VK_CONTROL;
    robot.keyPress(control);
    key(code);
    robot.keyRelease(control);
    robot.waitForIdle();
  }

  /** Moves the pointer to a place in a part. */
  void moveTo(Component part, int x, int y) {
    Point corner = EventThread.on(part::getLocationOnScreen);
    robot.mouseMove(corner.x + x, corner.y + y);
    robot.waitForIdle();
  }

  /** Clicks on the middle of a part. */
  void click(Component part) {
    click(part, part.getWidth() / 2, part.getHeight() / 2);
  }

  /** Clicks on a place in a part. */
  void click(Component part, int x, int y) {
    moveTo(part, x, y);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    robot.waitForIdle();
  }

  /** Drags from a place in a part to another, in some steps. */
  void drag(Component part, Point from, Point to, int buttonMask) {
    moveTo(part, from.x, from.y);
    robot.mousePress(buttonMask);
    for (int i = 1; i <= 5; i++) {
      moveTo(part, from.x + (to.x - from.x) * i / 5, from.y + (to.y - from.y) * i / 5);
    }
    robot.mouseRelease(buttonMask);
    robot.waitForIdle();
  }

  /** Does something while a key is down. */
  void with(int key, Runnable work) {
    robot.keyPress(key);
    work.run();
    robot.keyRelease(key);
    robot.waitForIdle();
  }

  /** Clicks twice on a place in a part. */
  void doubleClick(Component part, int x, int y) {
    moveTo(part, x, y);
    for (int i = 0; i < 2; i++) {
      robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
      robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }
    robot.waitForIdle();
  }

  /** Hands files to a window as a drop does; returns whether it took them. */
  boolean drop(JFrame onto, List<Path> files) {
    Transferable offer =
        new Transferable() {
          @Override
          public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {DataFlavor.javaFileListFlavor};
          }

          @Override
          public boolean isDataFlavorSupported(DataFlavor flavor) {
            return DataFlavor.javaFileListFlavor.equals(flavor);
          }

          @Override
          public Object getTransferData(DataFlavor flavor) {
            return files.stream().map(Path::toFile).toList();
          }
        };
    TransferHandler.TransferSupport support = new TransferHandler.TransferSupport(onto, offer);
    return EventThread.on(() -> onto.getTransferHandler().importData(support));
  }

  /** Turns the wheel over a part, away from the user if negative. */
  void wheel(int notches) {
    robot.mouseWheel(notches);
    robot.waitForIdle();
  }
}

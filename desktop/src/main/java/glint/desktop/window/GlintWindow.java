package glint.desktop.window;

import glint.image.Image;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.Box;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/** The window; all of it belongs to the event thread. */
public final class GlintWindow {

  private final JFrame frame = new JFrame("Glint");
  private final PictureView view = new PictureView(this::point);
  private final StatusBar status = new StatusBar();
  private final WorkMarks marks = new WorkMarks();
  private final Stage stage = new Stage(this::show);
  private final SceneList scenes = new SceneList(this::render);
  private final Notice notice = new Notice();
  private final Workers workers = new Workers();
  private final Problems problems = new Problems(this::edit);
  private final SidePanel side = new SidePanel();
  private final Viewing viewing = new Viewing(this::show, workers);
  private final FileDialogs dialogs = new FileDialogs(frame);
  private final OpenFiles files;
  private final ImageWork images;
  private final Editor editor;
  private final CountDownLatch closed = new CountDownLatch(1);
  private JButton pause;
  private Theme theme = Theme.LIGHT;
  private Picked picked;
  private Snapshot snapshot;
  private Image linear;
  private Point pointer;
  private Dimension size;
  private boolean paused;

  private GlintWindow(Desk desk) {
    files = new OpenFiles(desk.scenes(), scenes, problems, workers);
    images = new ImageWork(desk.images(), workers, notice);
    editor = new Editor(desk.environment());
  }

  /** Opens a window with the scenes of files and returns it; not for the event thread. */
  public static GlintWindow open(List<Path> files, Desk desk) throws InterruptedException {
    GlintWindow[] made = new GlintWindow[1];
    try {
      SwingUtilities.invokeAndWait(
          () -> {
            Theme.LIGHT.apply();
            made[0] = new GlintWindow(desk);
            made[0].lay();
          });
    } catch (java.lang.reflect.InvocationTargetException e) {
      throw new IllegalStateException("the window cannot be opened: " + e.getCause(), e.getCause());
    }
    made[0].files.open(files);
    return made[0];
  }

  /** Waits until the window is closed. */
  public void awaitClosed() throws InterruptedException {
    closed.await();
  }

  private void lay() {
    view.add(marks);
    new Hand(view, stage, pixel -> {}, stage::aim);
    Controls controls = new Controls(frame.getRootPane());
    addCommands(controls);
    controls.bar().add(Box.createHorizontalGlue());
    controls.bar().add(notice);
    JScrollPane list = new JScrollPane(scenes);
    list.setMinimumSize(new Dimension(160, 100));
    JPanel left = new JPanel(new BorderLayout());
    left.add(list, BorderLayout.CENTER);
    JPanel centre = new JPanel(new BorderLayout());
    centre.add(view, BorderLayout.CENTER);
    centre.add(viewing.strip(), BorderLayout.SOUTH);
    JSplitPane right = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, centre, side);
    right.setResizeWeight(1);
    JSplitPane middle = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, left, right);
    middle.setDividerLocation(220);
    frame.setTransferHandler(new FileDrop(files::open));
    scenes.setTransferHandler(frame.getTransferHandler());
    frame.add(controls.bar(), BorderLayout.NORTH);
    JPanel below = new JPanel(new BorderLayout());
    below.add(problems, BorderLayout.CENTER);
    below.add(status, BorderLayout.SOUTH);
    frame.add(middle, BorderLayout.CENTER);
    frame.add(below, BorderLayout.SOUTH);
    frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            stage.close();
            workers.end();
            closed.countDown();
          }
        });
    frame.pack();
    frame.setLocationByPlatform(true);
    frame.setVisible(true);
    scenes.requestFocusInWindow();
  }

  private void addCommands(Controls controls) {
    controls.menu("File");
    controls.add("Open", "O, menu O", this::open);
    controls.add("Save image", "menu S", this::save);
    controls.item("Copy picture", "menu C", this::copy);
    controls.item("Compare with", "menu D", () -> compare(() -> {}));
    controls.item("Next problem", "F8", problems::openNext);
    controls.item("Close", "menu W, menu Q", frame::dispose);
    controls.gap();
    controls.menu("Render");
    pause = controls.add("Pause", "SPACE", this::pauseOrGoOn);
    controls.add("Stop", "ESCAPE", stage::stop);
    controls.gap();
    controls.menu("View");
    controls.add("Fit", "F", view::fit);
    controls.add("1:1", "1", view::oneToOne);
    controls.item("Larger", "PLUS, shift EQUALS, EQUALS, ADD", () -> view.zoomBy(1));
    controls.item("Smaller", "MINUS, SUBTRACT", () -> view.zoomBy(-1));
    controls.gap();
    addLooks(controls);
    controls.gap();
    controls.item("Light or dark", "D", this::changeTheme);
    new CameraCommands(stage, notice).add(controls);
  }

  private void addLooks(Controls controls) {
    ButtonGroup looks = new ButtonGroup();
    controls.choice(looks, "Picture", "P", () -> viewing.show(Look.PICTURE));
    controls.choice(looks, "Error", "E", () -> viewing.show(Look.ERROR));
    controls.choice(looks, "Samples", "N", () -> viewing.show(Look.SAMPLES));
    controls.choice(looks, "Split", "B", () -> look(Look.SPLIT));
    controls.choice(looks, "Difference", "X", () -> look(Look.DIFFERENCE));
  }

  private void open() {
    files.open(dialogs.openScenes());
  }

  private void save() {
    if (snapshot != null && snapshot.linear().isPresent()) {
      Optional<Path> file = dialogs.saveImage(picked.scene().name());
      file.ifPresent(to -> images.save(picked, snapshot, to));
    }
  }

  private void copy() {
    if (view.picture() != null) {
      images.copy(view.picture());
    }
  }

  /** Asks for an image to compare with, and does something once it is there. */
  private void compare(Runnable then) {
    if (picked != null) {
      Consumer<Comparand> receiver =
          read -> {
            viewing.compare(read);
            then.run();
          };
      dialogs.openImage().ifPresent(file -> images.load(file, picked.scene().transfer(), receiver));
    }
  }

  private void look(Look look) {
    viewing.show(look);
    if (viewing.other().isEmpty()) {
      compare(() -> viewing.show(look));
    }
  }

  private void edit(Place place) {
    workers.disk(
        () -> {
          try {
            editor.open(place);
          } catch (IOException | RuntimeException e) {
            String why = "cannot open " + place + ": " + e.getMessage();
            SwingUtilities.invokeLater(() -> notice.say(why));
          }
        });
  }

  private void render(Picked next) {
    picked = next;
    viewing.begin();
    frame.setTitle(picked.scene().name() + " - Glint");
    size = new Dimension(picked.scene().width(), picked.scene().height());
    stage.show(picked);
  }

  private void show(Snapshot next) {
    snapshot = next;
    boolean moving = snapshot.state() == Snapshot.State.MOVING;
    marks.mark(snapshot.inWork());
    viewing.show(snapshot);
    side.show(snapshot);
    linear = snapshot.linear().orElse(moving ? null : linear);
    status.show(snapshot);
    paused = snapshot.state() == Snapshot.State.PAUSED;
    pause.getAction().putValue(Action.NAME, paused ? "Continue" : "Pause");
    pause.getAction().setEnabled(!snapshot.state().isOver());
    point(pointer);
  }

  private void show(BufferedImage picture) {
    view.show(picture, size);
  }

  private void pauseOrGoOn() {
    stage.pause(!paused);
  }

  private void changeTheme() {
    theme = theme.other();
    theme.apply();
  }

  private void point(Point pixel) {
    pointer = pixel;
    boolean inside = linear != null && pixel != null;
    inside = inside && pixel.x < linear.width() && pixel.y < linear.height();
    status.point(inside ? pixel : null, linear);
  }
}

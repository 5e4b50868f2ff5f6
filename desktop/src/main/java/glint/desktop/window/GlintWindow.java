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
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/** The window; all of it belongs to the event thread. */
public final class GlintWindow {

  private static final String THEME = "theme";

  private final JFrame frame = new JFrame("Glint");
  private final PictureView view = new PictureView(this::point);
  private final StatusBar status = new StatusBar();
  private final WorkMarks marks = new WorkMarks();
  private final Stage stage = new Stage(this::show);
  private final Thumbnails thumbnails;
  private final SceneList scenes;
  private final Notice notice = new Notice();
  private final Workers workers = new Workers();
  private final Problems problems = new Problems(this::edit);
  private final SidePanel side = new SidePanel(this::measures);
  private final RayInspector rays = new RayInspector(stage, view, side);
  private final Viewing viewing = new Viewing(this::show, workers);
  private final FileDialogs dialogs = new FileDialogs(frame);
  private final Remembered memory;
  private final JScrollPane list = new JScrollPane();
  private final OpenFiles files;
  private final ImageCommands images;
  private final RenderCommands render;
  private final Editor editor;
  private final CountDownLatch closed = new CountDownLatch(1);
  private Theme theme;
  private Image linear;
  private Point pointer;
  private Dimension size;

  private GlintWindow(Desk desk, Remembered memory, Theme theme) {
    this.memory = memory;
    this.theme = theme;
    thumbnails = new Thumbnails(new ThumbnailCache(desk.cache()), frame::repaint);
    scenes = new SceneList(this::render, thumbnails::of);
    files = new OpenFiles(desk.scenes(), scenes, problems, workers, thumbnails);
    ImageWork work = new ImageWork(desk.images(), workers, notice);
    images = new ImageCommands(viewing, work, dialogs, view::picture);
    render = new RenderCommands(stage, side::measure);
    editor = new Editor(desk.environment());
  }

  /** Opens a window with the scenes of files and returns it; not for the event thread. */
  public static GlintWindow open(List<Path> files, Desk desk) throws InterruptedException {
    Warmup.start();
    GlintWindow[] made = new GlintWindow[1];
    Remembered memory = Remembered.read(desk.state());
    Theme theme = Theme.named(memory.word(THEME).orElse(""));
    try {
      SwingUtilities.invokeAndWait(
          () -> {
            theme.apply();
            made[0] = new GlintWindow(desk, memory, theme);
            made[0].lay();
            made[0].open(files);
          });
    } catch (java.lang.reflect.InvocationTargetException e) {
      throw new IllegalStateException("the window cannot be opened: " + e.getCause(), e.getCause());
    }
    return made[0];
  }

  /** Waits until the window is closed. */
  public void awaitClosed() throws InterruptedException {
    closed.await();
  }

  private void lay() {
    view.add(marks);
    new Hand(view, stage, rays::clicked, rays::doubleClicked);
    Controls controls = new Controls(frame.getRootPane());
    addCommands(controls);
    controls.bar().add(notice);
    list.setViewportView(scenes);
    list.setMinimumSize(new Dimension(120, 100));
    list.setPreferredSize(new Dimension(230, 100));
    JPanel centre = new JPanel(new BorderLayout());
    centre.add(view, BorderLayout.CENTER);
    centre.add(viewing.strip(), BorderLayout.SOUTH);
    JSplitPane right = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, centre, side);
    right.setResizeWeight(1);
    JSplitPane middle = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, list, right);
    FrameMemory place = new FrameMemory(memory, frame, middle, right);
    frame.setTransferHandler(new FileDrop(this::open));
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
            place.keep();
            end();
          }
        });
    place.restore();
    frame.setVisible(true);
    scenes.requestFocusInWindow();
  }

  private void addCommands(Controls controls) {
    JMenu menu = controls.menu("File");
    controls.add("Open", "O, menu O", () -> open(dialogs.openScenes()));
    menu.add(new RecentMenu(memory::recent, this::open));
    images.addFiles(controls);
    controls.item("Next problem", "F8", problems::openNext);
    controls.item("Close", "menu W, menu Q", frame::dispose);
    controls.gap();
    render.add(controls);
    controls.gap();
    controls.menu("View");
    controls.add("Fit", "F", view::fit);
    controls.add("1:1", "1", view::oneToOne);
    controls.item("Larger", "PLUS, shift EQUALS, EQUALS, ADD", () -> view.zoomBy(1));
    controls.item("Smaller", "MINUS, SUBTRACT", () -> view.zoomBy(-1));
    controls.gap();
    images.addLooks(controls);
    controls.gap();
    controls.item("Light or dark", "D", this::changeTheme);
    controls.item("Scenes", "F6", () -> list.setVisible(!list.isVisible()));
    controls.item("About the render", "F7", () -> side.setVisible(!side.isVisible()));
    new CameraCommands(stage, notice).add(controls);
    controls.gap();
    rays.add(controls);
    controls.menu("Help");
    controls.item(
        "Keys",
        "F1, shift SLASH",
        () -> new Shortcuts(frame, controls.commands()).setVisible(true));
  }

  private void open(List<Path> named) {
    named.forEach(memory::opened);
    files.open(named);
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
    thumbnails.allow(false);
    viewing.begin(next);
    frame.setTitle(next.scene().name() + " - Glint");
    size = new Dimension(next.scene().width(), next.scene().height());
    rays.clear();
    stage.show(next);
  }

  private void show(Snapshot snapshot) {
    thumbnails.allow(snapshot.state().isOver());
    boolean moving = snapshot.state() == Snapshot.State.MOVING;
    if (moving) {
      rays.clear();
    }
    marks.mark(snapshot.inWork());
    viewing.show(snapshot);
    side.show(snapshot);
    linear = snapshot.linear().orElse(moving ? null : linear);
    status.show(snapshot);
    render.show(snapshot.state());
    point(pointer);
  }

  private void show(BufferedImage picture) {
    if (size != null) {
      view.show(picture, size);
    }
  }

  /** While something is measured, nothing else is done. */
  private void measures(boolean now) {
    thumbnails.allow(!now);
  }

  /** Ends all threads but one, which writes what is remembered. */
  private void end() {
    stage.end();
    viewing.end();
    linear = null;
    side.end();
    thumbnails.end();
    workers.end();
    Thread last =
        new Thread(
            () -> {
              memory.write();
              closed.countDown();
            },
            "glint-window-end");
    last.start();
  }

  private void changeTheme() {
    theme = theme.other();
    memory.word(THEME, theme.name());
    theme.apply();
  }

  private void point(Point pixel) {
    pointer = pixel;
    boolean inside = linear != null && pixel != null;
    inside = inside && pixel.x < linear.width() && pixel.y < linear.height();
    status.point(inside ? pixel : null, linear);
  }
}

package glint.desktop.window;

import glint.math.Vector3d;
import glint.scene.Scene;
import glint.scene.View;
import glint.trace.RayTree;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Draws the way of a pixel's rays through the picture: where they meet something, as it is seen.
 */
final class RayPath implements PictureView.Overlay {

  /** A ray that meets nothing is drawn for so many times the distance of its beginning. */
  private static final double FAR = 1e3;

  /** What is nearer to the eye than this part of the distance of the other end is not drawn. */
  private static final double NEAR = 1e-3;

  private static final Color SHADE = new Color(0, 0, 0, 150);
  private static final Color REFLECTED = new Color(255, 160, 40);
  private static final Color REFRACTED = new Color(70, 190, 255);
  private static final Color CHOSEN = Color.WHITE;
  private static final double DOT = 3;

  /**
   * A ray in the picture, in columns and rows; immutable.
   *
   * @param ray its number in the tree
   * @param ends whether it meets something there, and is not merely seen no farther
   */
  record Leg(int ray, RayTree.Kind kind, Line2D way, boolean ends) {}

  private List<Leg> legs = List.of();
  private Rectangle pixel;
  private int chosen;

  /** Draws no path. */
  void clear() {
    legs = List.of();
    pixel = null;
  }

  /** Draws the path of a pixel's rays from now on. */
  void show(PixelRays rays) {
    Point at = rays.pixel();
    pixel = new Rectangle(at.x, at.y, 1, 1);
    legs = legs(rays);
    chosen = 0;
  }

  /** Stresses a ray, by its number in the tree; 0 for none. */
  void choose(int ray) {
    chosen = ray;
  }

  /**
   * Returns all rays but the camera's, which is a point, as far as they are in front of the eye.
   */
  static List<Leg> legs(PixelRays rays) {
    Scene scene = rays.scene().scene();
    View view = new View(scene.camera(), scene.width(), scene.height());
    List<Leg> legs = new ArrayList<>();
    for (RayTree ray : rays.sample().tree().rays()) {
      boolean ends = ray.met().isPresent();
      Vector3d from = ray.origin();
      double far = FAR * (1 + Math.abs(view.depth(from.x(), from.y(), from.z())));
      Vector3d to = ends ? ray.met().get().point() : from.plus(ray.direction().times(far));
      Line2D way = ray.parent() == 0 ? null : seen(view, from, to);
      if (way != null) {
        boolean inFront = view.depth(to.x(), to.y(), to.z()) > 0;
        legs.add(new Leg(ray.number(), ray.kind(), way, ends && inFront));
      }
    }
    return legs;
  }

  /** Returns what is seen of the line between two points, or null. */
  private static Line2D seen(View view, Vector3d from, Vector3d to) {
    double a = view.depth(from.x(), from.y(), from.z());
    double b = view.depth(to.x(), to.y(), to.z());
    double near = NEAR * (a > 0 ? a : b);
    if (!(near > 0)) {
      return null;
    }
    Vector3d way = to.minus(from);
    Vector3d begin = a < near ? from.plus(way.times((near - a) / (b - a))) : from;
    Vector3d end = b < near ? from.plus(way.times((near - a) / (b - a))) : to;
    return new Line2D.Double(place(view, begin), place(view, end));
  }

  private static Point2D place(View view, Vector3d p) {
    double[] out = new double[2];
    view.project(p.x(), p.y(), p.z(), out);
    return new Point2D.Double(out[0], out[1]);
  }

  @Override
  public void paint(Graphics2D graphics, Zoom zoom) {
    if (pixel == null) {
      return;
    }
    Graphics2D g = (Graphics2D) graphics.create();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    AffineTransform place =
        new AffineTransform(zoom.scale(), 0, 0, zoom.scale(), zoom.x(), zoom.y());
    for (Leg leg : legs) {
      Point2D from = place.transform(leg.way().getP1(), null);
      Point2D to = place.transform(leg.way().getP2(), null);
      Line2D line = new Line2D.Double(from, to);
      stroke(g, leg.ray() == chosen, line, color(leg.kind()));
      dot(g, from, color(leg.kind()));
      if (leg.ends()) {
        dot(g, to, color(leg.kind()));
      }
    }
    stroke(g, chosen == 1, zoom.of(pixel), CHOSEN);
    g.dispose();
  }

  private static Color color(RayTree.Kind kind) {
    return kind == RayTree.Kind.REFLECTION ? REFLECTED : REFRACTED;
  }

  private static void stroke(Graphics2D g, boolean stressed, Shape shape, Color color) {
    g.setColor(SHADE);
    g.setStroke(new BasicStroke(stressed ? 6 : 3));
    g.draw(shape);
    g.setColor(stressed ? CHOSEN : color);
    g.setStroke(new BasicStroke(stressed ? 3 : 1.5f));
    g.draw(shape);
  }

  private static void dot(Graphics2D g, Point2D at, Color color) {
    g.setColor(SHADE);
    g.fill(
        new Ellipse2D.Double(at.getX() - DOT - 1, at.getY() - DOT - 1, 2 * DOT + 2, 2 * DOT + 2));
    g.setColor(color);
    g.fill(new Ellipse2D.Double(at.getX() - DOT, at.getY() - DOT, 2 * DOT, 2 * DOT));
  }
}

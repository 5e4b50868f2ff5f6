package glint.bench;

import glint.math.Vector3d;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;

/**
 * Writes scenes/sphereflake.yaml: a ball with nine smaller balls around it, and so on.
 *
 * <p>Source: E. Haines, A Proposal for Standard Graphics Environments, IEEE CG&amp;A 7(11), 1987;
 * here with five levels, 7381 spheres, mirrors of 0.6 over a grey ground.
 */
public final class Sphereflake {

  private static final int LEVELS = 5;

  private final PrintStream out;

  private Sphereflake(PrintStream out) {
    this.out = out;
  }

  /** Writes the scene file to standard output. */
  public static void main(String[] args) {
    PrintStream out = new PrintStream(System.out, false, StandardCharsets.UTF_8);
    out.print(
        """
        # yaml-language-server: $schema=schema/glint-scene.schema.json
        # Made by ./gradlew -q :bench:sphereflake > scenes/sphereflake.yaml
        materials:
          ground: {color: 0.6}
          ball: {color: [1, 0.9, 0.8], ambient: 0, diffuse: 0.4, reflection: 0.6}

        scenes:
          sphereflake:
            title: Balls around balls, 7381 in all
            image: {width: 800, height: 600}
            camera: {position: [4, 4.5, 6], look_at: [0, 1.7, 0], fov: 36}
            background: [0.4, 0.5, 0.7]
            lights:
              - point: {position: [5, 10, 6], color: 1}
            surfaces:
              - plane: {point: [0, 0, 0], normal: [0, 1, 0], material: ground}
        """);
    new Sphereflake(out).ball(new Vector3d(0, 2, 0), 1, new Vector3d(0, 1, 0), LEVELS);
    out.flush();
  }

  /** Writes a ball and, around its axis, six at its middle and three above. */
  private void ball(Vector3d center, double radius, Vector3d axis, int levels) {
    String place = number(center.x()) + ", " + number(center.y()) + ", " + number(center.z());
    String size = number(radius);
    out.println("      - sphere: {center: [" + place + "], radius: " + size + ", material: ball}");
    if (levels == 1) {
      return;
    }
    Vector3d aside = Math.abs(axis.x()) < 0.6 ? new Vector3d(1, 0, 0) : new Vector3d(0, 1, 0);
    Vector3d u = axis.cross(aside).normalized();
    Vector3d v = axis.cross(u);
    for (int i = 0; i < 6; i++) {
      child(center, radius, around(u, v, 60 * i), levels);
    }
    // The three above stand where the balls of a pile would: their angle to the axis is asin √⅓.
    double sin = Math.sqrt(1.0 / 3);
    double cos = Math.sqrt(2.0 / 3);
    for (int i = 0; i < 3; i++) {
      Vector3d out = around(u, v, 120 * i + 30).times(sin).plus(axis.times(cos));
      child(center, radius, out, levels);
    }
  }

  private void child(Vector3d center, double radius, Vector3d direction, int levels) {
    ball(center.plus(direction.times(radius * 4 / 3)), radius / 3, direction, levels - 1);
  }

  /** Nine digits, as the peers get them. */
  private static String number(double v) {
    BigDecimal rounded = new BigDecimal(v).round(new MathContext(9)).stripTrailingZeros();
    return rounded.abs().doubleValue() < 1e-15 ? "0" : rounded.toPlainString();
  }

  private static Vector3d around(Vector3d u, Vector3d v, double degrees) {
    double a = StrictMath.toRadians(degrees);
    return u.times(StrictMath.cos(a)).plus(v.times(StrictMath.sin(a)));
  }
}

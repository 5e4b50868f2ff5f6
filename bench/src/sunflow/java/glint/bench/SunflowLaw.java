package glint.bench;

import org.sunflow.SunflowAPI;
import org.sunflow.core.ParameterList;
import org.sunflow.core.Ray;
import org.sunflow.core.Shader;
import org.sunflow.core.ShadingState;
import org.sunflow.image.Color;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;

/**
 * Glint's law of surfaces for Sunflow: ambient and diffuse light and a mirror's, or clear glass.
 *
 * <p>It follows only what can bring more than a share of the light that is seen. One thread
 * renders.
 */
public final class SunflowLaw implements Shader {

  /** By how much a ray that passes a face begins behind it: past where Sunflow lays the point. */
  private static final float BEHIND = 0.004f;

  /** As many bounces as Sunflow's tables of sequences have room for. */
  static final int DEEPEST = 61;

  private static float cutoff;

  /** The share of the light at hand that is seen. */
  private static float share = 1;

  private Color ambient = Color.BLACK;
  private Color diffuse = Color.BLACK;
  private float reflection;
  private float ior;

  /** Sets the share that is not followed. */
  static void cutOff(float least) {
    cutoff = least;
  }

  @Override
  public boolean update(ParameterList parameters, SunflowAPI api) {
    ambient = parameters.getColor("ambient", ambient);
    diffuse = parameters.getColor("diffuse", diffuse);
    reflection = parameters.getFloat("reflection", reflection);
    ior = parameters.getFloat("ior", ior);
    return true;
  }

  @Override
  public Color getRadiance(ShadingState state) {
    state.faceforward();
    if (ior > 0) {
      return glass(state);
    }
    state.initLightSamples();
    Color light = state.diffuse(diffuse).add(ambient);
    return reflection > 0 ? light.add(mirrored(state, reflection)) : light;
  }

  private Color glass(ShadingState state) {
    float eta = state.isBehind() ? ior : 1 / ior;
    float cos = state.getCosND();
    float cos2 = 1 - eta * eta * (1 - cos * cos);
    if (cos2 <= 0) {
      return mirrored(state, 1);
    }
    float beyond = (float) Math.sqrt(cos2);
    float s = (eta * cos - beyond) / (eta * cos + beyond);
    float p = (cos - eta * beyond) / (cos + eta * beyond);
    float fresnel = (s * s + p * p) / 2;
    return mirrored(state, fresnel).add(refracted(state, 1 - fresnel, eta, beyond));
  }

  private static Color mirrored(ShadingState state, float part) {
    return traced(state, part, state.getPoint(), 1, 2 * state.getCosND(), true);
  }

  private static Color refracted(ShadingState state, float part, float eta, float beyond) {
    Vector3 n = state.getGeoNormal();
    Point3 p = state.getPoint();
    Point3 start = new Point3(p.x - BEHIND * n.x, p.y - BEHIND * n.y, p.z - BEHIND * n.z);
    return traced(state, part, start, eta, eta * state.getCosND() - beyond, false);
  }

  /** Follows the ray along·d + across·n. */
  private static Color traced(
      ShadingState state, float part, Point3 start, float along, float across, boolean mirror) {
    float before = share;
    if (before * part <= cutoff || state.getDepth() >= DEEPEST) {
      return Color.black();
    }
    share = before * part;
    Vector3 d = state.getRay().getDirection();
    Vector3 n = state.getNormal();
    Vector3 way =
        new Vector3(
            along * d.x + across * n.x, along * d.y + across * n.y, along * d.z + across * n.z);
    Ray ray = new Ray(start, way);
    Color light = mirror ? state.traceReflection(ray, 0) : state.traceRefraction(ray, 0);
    share = before;
    return light.copy().mul(part);
  }

  @Override
  public void scatterPhoton(ShadingState state, Color power) {
    throw new UnsupportedOperationException();
  }

  @Override
  public boolean isOpaque() {
    return true;
  }

  @Override
  public Color getOpacity(ShadingState state) {
    return Color.WHITE;
  }
}

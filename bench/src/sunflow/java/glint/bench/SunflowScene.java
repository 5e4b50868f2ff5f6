package glint.bench;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Sphere;
import glint.light.Light;
import glint.math.Transform;
import glint.math.Vector3d;
import glint.optics.Material;
import glint.scene.Perspective;
import glint.scene.Placement;
import glint.scene.Scene;
import org.sunflow.PluginRegistry;
import org.sunflow.SunflowAPI;
import org.sunflow.core.CameraLens;
import org.sunflow.core.ParameterList;
import org.sunflow.core.Ray;
import org.sunflow.core.ShadingState;
import org.sunflow.core.primitive.Background;
import org.sunflow.math.Matrix4;
import org.sunflow.math.OrthoNormalBasis;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;

/** Writes a scene of Glint's for Sunflow, as far as both have the same. */
final class SunflowScene {

  static final String CAMERA = "camera";

  /** Sunflow begins rays 0.001 above faces: enough for floats where scenes count in tens. */
  private static final double SCALE = 0.05;

  private SunflowScene() {}

  /**
   * A pinhole whose picture covers the pixels from edge to edge.
   *
   * <p>Sunflow's own lays their first and last corners on the edges of the view.
   */
  public static final class Pinhole implements CameraLens {
    private float halfWidth;
    private float halfHeight;

    @Override
    public boolean update(ParameterList parameters, SunflowAPI api) {
      halfWidth = parameters.getFloat("half.width", halfWidth);
      halfHeight = parameters.getFloat("half.height", halfHeight);
      return true;
    }

    @Override
    public Ray getRay(float x, float y, int w, int h, double lensX, double lensY, double time) {
      return new Ray(0, 0, 0, halfWidth * (2 * x / w - 1), halfHeight * (2 * y / h - 1), -1);
    }
  }

  /** What is around everything; Sunflow's own is black to all but the camera. */
  public static final class Sky extends Background {
    @Override
    public void prepareShadingState(ShadingState state) {
      state.setShader(state.getInstance().getShader(0));
    }
  }

  /** A box whose normals are turned with it and point outwards, as Sunflow's own do not. */
  public static final class TurnedBox extends org.sunflow.core.primitive.Box {
    @Override
    public void prepareShadingState(ShadingState state) {
      super.prepareShadingState(state);
      Vector3 own = state.getGeoNormal();
      Point3 at = state.transformWorldToObject(state.getPoint());
      Vector3 outward =
          new Vector3(outward(own.x, at.x, 0), outward(own.y, at.y, 1), outward(own.z, at.z, 2));
      Vector3 normal = state.transformNormalObjectToWorld(outward).normalize();
      state.getGeoNormal().set(normal);
      state.getNormal().set(normal);
      state.setBasis(OrthoNormalBasis.makeFromW(normal));
    }

    private float outward(float normal, float at, int axis) {
      float middle = (getPrimitiveBound(0, 2 * axis) + getPrimitiveBound(0, 2 * axis + 1)) / 2;
      return Math.copySign(normal, at - middle);
    }
  }

  static SunflowAPI of(Scene scene, int width, int height) {
    if (!PluginRegistry.shaderPlugins.hasType("law")) {
      PluginRegistry.shaderPlugins.registerPlugin("law", SunflowLaw.class);
      PluginRegistry.lightSourcePlugins.registerPlugin("lamp", SunflowLamp.class);
      PluginRegistry.primitivePlugins.registerPlugin("sky", Sky.class);
      PluginRegistry.primitivePlugins.registerPlugin("turned", TurnedBox.class);
      PluginRegistry.cameraLensPlugins.registerPlugin("edges", Pinhole.class);
    }
    SunflowAPI api = new SunflowAPI();
    camera(api, scene, width, height);
    color(api, "color", scene.background().up());
    api.shader("background.shader", "constant");
    api.geometry("background", "sky");
    api.parameter("shaders", new String[] {"background.shader"});
    api.instance("background.instance", "background");
    Rgb ambient = Rgb.BLACK;
    int lamps = 0;
    for (Light light : scene.lights()) {
      if (light instanceof Light.Ambient everywhere) {
        ambient = ambient.plus(everywhere.color());
      } else if (light instanceof Light.Point point && !point.inverseSquare()) {
        api.parameter("center", point(point.position()));
        color(api, "radiance", point.color());
        api.light("lamp" + lamps++, "lamp");
      } else {
        throw new IllegalArgumentException("no such lamp: " + light);
      }
    }
    for (int i = 0; i < scene.placements().size(); i++) {
      place(api, "surface" + i, scene.placements().get(i), ambient);
    }
    return api;
  }

  private static void camera(SunflowAPI api, Scene scene, int width, int height) {
    Perspective view = (Perspective) scene.camera().projection();
    Vector3d up = scene.camera().up();
    Vector3 upwards = new Vector3((float) up.x(), (float) up.y(), (float) up.z());
    Point3 eye = point(scene.camera().position());
    api.parameter("transform", Matrix4.lookAt(eye, point(scene.camera().lookAt()), upwards));
    api.parameter("half.width", (float) view.halfWidth(width, height));
    api.parameter("half.height", (float) view.halfHeight(width, height));
    api.camera(CAMERA, "edges");
  }

  private static void place(SunflowAPI api, String name, Placement placement, Rgb ambient) {
    Material material = placement.material();
    color(api, "ambient", material.ambient().times(ambient));
    color(api, "diffuse", material.diffuse());
    api.parameter("reflection", (float) material.reflection().g());
    api.parameter("ior", material.isTransparent() ? (float) material.interior().ior() : 0);
    api.shader(name + ".shader", "law");
    Transform toWorld = placement.toWorld();
    if (placement.surface() instanceof Sphere sphere) {
      Vector3d radius = new Vector3d(sphere.radius(), sphere.radius(), sphere.radius());
      toWorld = Transform.scale(radius).then(Transform.translate(sphere.center())).then(toWorld);
      api.geometry(name, "sphere");
    } else if (placement.surface() instanceof Box box) {
      float[] corners = {
        (float) box.min().x(), (float) box.min().y(), (float) box.min().z(),
        (float) box.max().x(), (float) box.max().y(), (float) box.max().z()
      };
      api.parameter("points", "point", "vertex", corners);
      api.geometry(name, "turned");
    } else {
      throw new IllegalArgumentException("no such surface: " + placement.surface());
    }
    double[] m = toWorld.then(Transform.scale(new Vector3d(SCALE, SCALE, SCALE))).rows();
    float[] rows = new float[16];
    for (int i = 0; i < m.length; i++) {
      rows[i] = (float) m[i];
    }
    rows[15] = 1;
    api.parameter("shaders", new String[] {name + ".shader"});
    api.parameter("transform", new Matrix4(rows, true));
    api.instance(name + ".instance", name);
  }

  private static Point3 point(Vector3d p) {
    Vector3d scaled = p.times(SCALE);
    return new Point3((float) scaled.x(), (float) scaled.y(), (float) scaled.z());
  }

  private static void color(SunflowAPI api, String name, Rgb c) {
    api.parameter(name, "sRGB linear", (float) c.r(), (float) c.g(), (float) c.b());
  }
}

package glint.bench;

import glint.color.Rgb;
import glint.geometry.Box;
import glint.geometry.Mesh;
import glint.geometry.Plane;
import glint.geometry.Sphere;
import glint.geometry.Surface;
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
import org.sunflow.core.IntersectionState;
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

  /** From the eye to what it looks at: Sunflow begins rays 0.001 above faces, and has floats. */
  private static final double DISTANCE = 300;

  private final SunflowAPI api = new SunflowAPI();
  private final double scale;

  private SunflowScene(double scale) {
    this.scale = scale;
  }

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

  /**
   * A unit sphere that is hit as exactly as floats allow.
   *
   * <p>Sunflow's own loses small spheres far away in the digits that cancel.
   */
  public static final class Ball extends org.sunflow.core.primitive.Sphere {
    @Override
    public void intersectPrimitive(Ray ray, int id, IntersectionState state) {
      double a = (double) ray.dx * ray.dx + (double) ray.dy * ray.dy + (double) ray.dz * ray.dz;
      double b = (double) ray.ox * ray.dx + (double) ray.oy * ray.dy + (double) ray.oz * ray.dz;
      double c = (double) ray.ox * ray.ox + (double) ray.oy * ray.oy + (double) ray.oz * ray.oz;
      double square = b * b - a * (c - 1);
      if (square > 0) {
        double half = Math.sqrt(square);
        float near = (float) ((-b - half) / a);
        float t = near > ray.getMin() ? near : (float) ((half - b) / a);
        if (ray.isInside(t)) {
          ray.setMax(t);
          state.setIntersection(0);
        }
      }
    }
  }

  /** Returns the scene for Sunflow. */
  static SunflowAPI of(Scene scene, int width, int height) {
    if (!PluginRegistry.shaderPlugins.hasType("law")) {
      PluginRegistry.shaderPlugins.registerPlugin("law", SunflowLaw.class);
      PluginRegistry.lightSourcePlugins.registerPlugin("lamp", SunflowLamp.class);
      PluginRegistry.primitivePlugins.registerPlugin("sky", Sky.class);
      PluginRegistry.primitivePlugins.registerPlugin("turned", TurnedBox.class);
      PluginRegistry.primitivePlugins.registerPlugin("ball", Ball.class);
      PluginRegistry.cameraLensPlugins.registerPlugin("edges", Pinhole.class);
    }
    Vector3d view = scene.camera().lookAt().minus(scene.camera().position());
    SunflowScene written = new SunflowScene(DISTANCE / view.length());
    written.write(scene, width, height);
    return written.api;
  }

  private void write(Scene scene, int width, int height) {
    camera(scene, width, height);
    color("color", scene.background().up());
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
        color("radiance", point.color());
        api.light("lamp" + lamps++, "lamp");
      } else {
        throw new IllegalArgumentException("no such lamp: " + light);
      }
    }
    for (int i = 0; i < scene.placements().size(); i++) {
      place("surface" + i, scene.placements().get(i), ambient);
    }
  }

  private void camera(Scene scene, int width, int height) {
    Perspective view = (Perspective) scene.camera().projection();
    Point3 eye = point(scene.camera().position());
    Vector3 up = vector(scene.camera().up());
    api.parameter("transform", Matrix4.lookAt(eye, point(scene.camera().lookAt()), up));
    api.parameter("half.width", (float) view.halfWidth(width, height));
    api.parameter("half.height", (float) view.halfHeight(width, height));
    api.camera(CAMERA, "edges");
  }

  private void place(String name, Placement placement, Rgb ambient) {
    Material material = placement.material();
    color("ambient", material.ambient().times(ambient));
    color("diffuse", material.diffuse());
    api.parameter("reflection", (float) material.reflection().g());
    api.parameter("ior", material.isTransparent() ? (float) material.interior().ior() : 0);
    api.shader(name + ".shader", "law");
    shape(name, placement.surface(), placement.toWorld());
    api.parameter("shaders", new String[] {name + ".shader"});
    api.instance(name + ".instance", name);
  }

  /** Makes the shape, and says how it is placed. */
  private void shape(String name, Surface surface, Transform toWorld) {
    if (surface instanceof Sphere sphere) {
      api.geometry(name, "ball");
      transform(even(sphere.radius()).then(Transform.translate(sphere.center())).then(toWorld));
    } else if (surface instanceof Box box) {
      float[] corners = {
        (float) box.min().x(), (float) box.min().y(), (float) box.min().z(),
        (float) box.max().x(), (float) box.max().y(), (float) box.max().z()
      };
      api.parameter("points", "point", "vertex", corners);
      api.geometry(name, "turned");
      transform(toWorld);
    } else if (surface instanceof Plane plane) {
      // Sunflow leaves normals of planes as long as a transform makes them.
      api.parameter("center", point(toWorld.point(plane.point())));
      api.parameter("normal", vector(toWorld.normal(plane.normal()).normalized()));
      api.geometry(name, "plane");
    } else if (surface instanceof Mesh mesh) {
      float[] points = new float[9 * mesh.triangles()];
      int[] corners = new int[3 * mesh.triangles()];
      for (int i = 0; i < points.length; i++) {
        points[i] = (float) mesh.coordinate(i / 9, i / 3 % 3, i % 3);
        corners[i / 3] = i / 3;
      }
      api.parameter("points", "point", "vertex", points);
      api.parameter("triangles", corners);
      api.geometry(name, "triangle_mesh");
      transform(toWorld);
    } else {
      throw new IllegalArgumentException("no such surface: " + surface);
    }
  }

  private void transform(Transform toWorld) {
    double[] m = toWorld.then(even(scale)).rows();
    float[] rows = new float[16];
    for (int i = 0; i < m.length; i++) {
      rows[i] = (float) m[i];
    }
    rows[15] = 1;
    api.parameter("transform", new Matrix4(rows, true));
  }

  private void color(String name, Rgb c) {
    api.parameter(name, "sRGB linear", (float) c.r(), (float) c.g(), (float) c.b());
  }

  private Point3 point(Vector3d p) {
    return new Point3((float) (scale * p.x()), (float) (scale * p.y()), (float) (scale * p.z()));
  }

  private static Vector3 vector(Vector3d v) {
    return new Vector3((float) v.x(), (float) v.y(), (float) v.z());
  }

  private static Transform even(double factor) {
    return Transform.scale(new Vector3d(factor, factor, factor));
  }
}

package glint.bench;

import org.sunflow.SunflowAPI;
import org.sunflow.core.Instance;
import org.sunflow.core.LightSample;
import org.sunflow.core.LightSource;
import org.sunflow.core.ParameterList;
import org.sunflow.core.Ray;
import org.sunflow.core.ShadingState;
import org.sunflow.image.Color;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;

/** A point that shines equally bright at every distance, as Sunflow has none. */
public final class SunflowLamp implements LightSource {

  private Point3 center = new Point3();
  private Color radiance = Color.BLACK;

  @Override
  public boolean update(ParameterList parameters, SunflowAPI api) {
    center = parameters.getPoint("center", center);
    // Sunflow's diffuse law divides by π.
    radiance = parameters.getColor("radiance", radiance).copy().mul((float) Math.PI);
    return true;
  }

  @Override
  public int getNumSamples() {
    return 1;
  }

  @Override
  public void getSamples(ShadingState state) {
    Vector3 direction = Point3.sub(center, state.getPoint(), new Vector3());
    if (Vector3.dot(direction, state.getNormal()) > 0) {
      LightSample sample = new LightSample();
      sample.setShadowRay(new Ray(state.getPoint(), center));
      sample.setRadiance(radiance, radiance);
      sample.traceShadow(state);
      state.addSample(sample);
    }
  }

  @Override
  public void getPhoton(
      double u, double v, double s, double t, Point3 point, Vector3 direction, Color power) {
    throw new UnsupportedOperationException();
  }

  @Override
  public float getPower() {
    return radiance.getLuminance();
  }

  @Override
  public Instance createInstance() {
    return null;
  }
}

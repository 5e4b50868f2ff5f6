package glint.verify;

import java.util.ArrayList;
import java.util.List;

/** All hard cases, in the order in which {@code glint verify} prints them. */
public final class HardCases {

  private HardCases() {}

  /** Returns every case. */
  public static List<HardCase> all() {
    List<HardCase> cases = new ArrayList<>();
    cases.addAll(SphereCases.all());
    cases.addAll(TriangleCases.all());
    cases.addAll(MeshCases.all());
    cases.addAll(BvhCases.all());
    cases.addAll(CameraCases.all());
    cases.addAll(ShadowCases.all());
    cases.addAll(SmoothCases.all());
    cases.addAll(WorldCases.all());
    cases.addAll(FresnelCases.all());
    cases.addAll(BodyCases.all());
    cases.addAll(TouchingCases.all());
    cases.addAll(EnergyCases.all());
    cases.addAll(PathCases.all());
    cases.addAll(ColorCases.all());
    cases.addAll(LeavingCases.all());
    cases.addAll(InstanceCases.all());
    cases.addAll(QuaternionCases.all());
    cases.addAll(TransformCases.all());
    cases.addAll(AdversarialCases.all());
    return List.copyOf(cases);
  }
}

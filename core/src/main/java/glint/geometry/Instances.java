package glint.geometry;

import glint.math.Rounding;
import glint.math.Transform;
import java.util.List;

/**
 * Models, which are meshes in their own space, and the places where they are shown.
 *
 * <p>A place costs a transform, however many triangles its model has: the ray moves, not they.
 */
final class Instances {

  static final Instances NONE = new Instances(List.of(), new Transform[0], new int[0]);

  private final List<Primitives> models;

  /** The box around each model, and its largest diameter along the axes, summed up. */
  private final double[][] boxes;

  private final double[] extents;

  private final Transform[] places;

  /** The model of each place. */
  private final int[] modelOf;

  /** Takes over the arrays. */
  Instances(List<Primitives> models, Transform[] places, int[] modelOf) {
    this.models = models;
    this.places = places;
    this.modelOf = modelOf;
    boxes = new double[models.size()][];
    extents = new double[models.size()];
    for (int i = 0; i < boxes.length; i++) {
      boxes[i] = models.get(i).box();
      for (int axis = 0; axis < 3; axis++) {
        extents[i] += Math.max(0, boxes[i][3 + axis] - boxes[i][axis]);
      }
    }
  }

  List<Primitives> models() {
    return models;
  }

  /** Returns the same places with the models' primitives in another order. */
  Instances showing(List<Primitives> others) {
    return new Instances(others, places, modelOf);
  }

  int model(int place) {
    return modelOf[place];
  }

  /**
   * Sets {@code local} to a ray as the model at a place sees it.
   *
   * @param number that of the place, among primitives
   */
  void toModel(int place, int number, Ray ray, Ray local, double[] numbers) {
    places[place].copyTo(numbers);
    TransformedKernel.toObject(numbers, 0, ray, local);
    if (number == ray.after) {
      local.after = ray.afterPart;
    } else {
      local.after = number > ray.after ? -1 : Hit.NONE;
    }
  }

  /**
   * Fills in point, normal and offset of a hit at a place.
   *
   * <p>A direction's rounding on its way into the model turns it by at most γ(4)‖M‖‖M⁻¹‖, and so
   * does the normal's on its way here. The model's triangles may lie in one plane: a ray that all
   * but grazes it must start so high that it comes nowhere below within the whole model.
   */
  void resolve(int place, Hit hit) {
    int model = modelOf[place];
    models.get(model).resolveTriangle(hit.partSlot, hit);
    double[] numbers = hit.numbers;
    places[place].copyTo(numbers);
    double flattening = TransformedKernel.flattening(numbers, 0);
    hit.offset += Rounding.gamma(8) * flattening * extents[model];
    TransformedKernel.toWorld(numbers, 0, hit);
  }

  /** Returns the part of its model that a hit at a place is with. */
  int part(int place, Hit hit) {
    return models.get(modelOf[place]).surface(hit.partSlot);
  }

  void bounds(int place, double[] out) {
    System.arraycopy(boxes[modelOf[place]], 0, out, 0, 6);
    double[] numbers = new double[Transform.NUMBERS];
    places[place].copyTo(numbers);
    TransformedKernel.boundsToWorld(numbers, 0, out);
  }

  /** Returns what places and models take in memory, the transforms included. */
  long bytes() {
    long bytes = (4L + 4 + 8 * Transform.NUMBERS) * places.length;
    for (Primitives model : models) {
      bytes += model.bytes();
    }
    return bytes;
  }
}

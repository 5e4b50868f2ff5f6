package glint.report;

import glint.color.Transfer;
import glint.image.Image;

/**
 * An image of many samples: the mean of two halves that share none; immutable.
 *
 * @param samples samples per pixel of both halves together
 * @param uncertainty half the root mean square of what the halves differ by, in display levels
 */
public record Reference(Image image, int samples, double uncertainty, Transfer transfer)
    implements Truth {

  /** Makes a reference of two images of as many samples each. */
  public static Reference of(Image one, Image two, int samplesEach, Transfer transfer) {
    Image mean = new Image(one.width(), one.height());
    for (int i = 0; i < mean.rgb().length; i++) {
      mean.rgb()[i] = (one.rgb()[i] + two.rgb()[i]) / 2;
    }
    double apart = Errors.between(one, two, transfer).levels();
    return new Reference(mean, 2 * samplesEach, apart / 2, transfer);
  }

  @Override
  public Errors errors(Image other) {
    return Errors.between(other, image, transfer);
  }

  @Override
  public String origin() {
    return "2 × " + samples / 2 + " samples";
  }
}

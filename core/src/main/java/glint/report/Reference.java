package glint.report;

import glint.color.Transfer;
import glint.image.Image;

/**
 * An image of many samples: the mean of two halves that share none; immutable.
 *
 * @param origin how many samples it is of, in a few words
 * @param uncertainty half the root mean square of what the halves differ by, in display levels
 */
public record Reference(Image image, String origin, double uncertainty, Transfer transfer)
    implements Truth {

  /** Makes a reference of two halves. */
  public static Reference of(Image one, Image two, String origin, Transfer transfer) {
    Image mean = new Image(one.width(), one.height());
    for (int i = 0; i < mean.rgb().length; i++) {
      mean.rgb()[i] = (one.rgb()[i] + two.rgb()[i]) / 2;
    }
    double apart = Errors.between(one, two, transfer).levels();
    return new Reference(mean, origin, apart / 2, transfer);
  }

  @Override
  public Errors errors(Image other) {
    return Errors.between(other, image, transfer);
  }
}

package glint.report;

import glint.image.Image;

/** What the image of a scene should be. */
public interface Truth {

  /** Returns how far an image is off. */
  Errors errors(Image image);

  /** Returns how far the truth itself may be off: root mean square in display levels. */
  double uncertainty();

  /** Returns in a few words where the truth is from. */
  String origin();
}

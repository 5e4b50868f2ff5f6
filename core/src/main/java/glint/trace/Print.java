package glint.trace;

import glint.color.Rgb;
import glint.optics.ImageTexture;
import glint.optics.Texel;

/** An image on what a camera ray meets first: what it shows there, and how much that counts. */
public final class Print {

  /** Whether there is one. */
  public boolean found;

  /** Where in the image that is, as in {@link Texel#x}. */
  public double x;

  public double y;

  /** What radiance the ray would bring more, linear, for every unit more of the colour there. */
  public double gainR;

  public double gainG;
  public double gainB;

  /** The radiance that the colour there makes. */
  public double r;

  public double g;
  public double b;

  /** About the mean colour of the image. */
  public Rgb mean;

  void clear() {
    found = false;
  }

  /** Begins with a place of an image, in the dark. */
  void begin(ImageTexture image, Texel texel) {
    found = true;
    mean = image.mean();
    x = texel.x;
    y = texel.y;
    gainR = 0;
    gainG = 0;
    gainB = 0;
  }

  /** Adds light that the colour is multiplied by. */
  void add(double red, double green, double blue) {
    gainR += red;
    gainG += green;
    gainB += blue;
  }

  /** Ends with what is left of that where the ray begins. */
  void end(Texel texel, double weightR, double weightG, double weightB) {
    gainR *= weightR;
    gainG *= weightG;
    gainB *= weightB;
    r = gainR * texel.r;
    g = gainG * texel.g;
    b = gainB * texel.b;
  }
}

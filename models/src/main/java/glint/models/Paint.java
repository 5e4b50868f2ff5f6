package glint.models;

import glint.color.Rgb;

/**
 * A material of a model; immutable.
 *
 * @param name as the model's faces call it
 * @param lines what its MTL file says of it
 */
record Paint(String name, String lines) {

  /** Returns a dull paint. */
  static Paint dull(String name, double red, double green, double blue) {
    return new Paint(name, "Kd " + color(new Rgb(red, green, blue)));
  }

  /** Returns this paint with a highlight. */
  Paint shiny(double strength, int exponent) {
    return with("Ks " + Numbers.text(strength) + "\nNs " + exponent);
  }

  /** Returns this paint as a mirror as well. */
  Paint mirror(double red, double green, double blue, int exponent) {
    String specular = "Ks " + color(new Rgb(red, green, blue));
    return with(specular + "\nNs " + exponent + "\nillum 3");
  }

  /** Returns this paint with light of its own. */
  Paint glowing(double red, double green, double blue) {
    return with("Ke " + color(new Rgb(red, green, blue)));
  }

  /** Returns this paint as thin as air: it covers a share of what is behind. */
  Paint covering(double share) {
    return with("d " + Numbers.text(share));
  }

  private Paint with(String line) {
    return new Paint(name, lines + "\n" + line);
  }

  private static String color(Rgb c) {
    return Numbers.text(c.r()) + " " + Numbers.text(c.g()) + " " + Numbers.text(c.b());
  }
}

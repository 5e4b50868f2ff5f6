package glint.desktop.report;

import glint.report.Curve;
import java.util.List;

/**
 * Speed against error of some scenes, and what they were measured on; immutable.
 *
 * @param command what made the report
 * @param environment what it was measured on
 * @param entries at least one
 */
public record Report(String command, Environment environment, List<Entry> entries) {

  /**
   * What measured.
   *
   * @param version of Glint
   * @param commit of the sources; empty if it is not known
   * @param java name and version of the Java machine, and its options
   * @param machine processor and system
   * @param threads workers of a render
   */
  public record Environment(
      String version, String commit, String java, String machine, int threads) {}

  /**
   * One scene.
   *
   * @param file where it was read
   * @param name the scene's name, which no other entry has
   * @param title a line for people
   * @param width columns of the image
   * @param height rows of the image
   * @param uniform error against cost, every pixel having as many samples as all others
   */
  public record Entry(
      String file, String name, String title, int width, int height, Curve uniform) {}
}

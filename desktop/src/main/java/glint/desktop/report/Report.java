package glint.desktop.report;

import glint.report.Curve;
import glint.report.DepthStudy;
import glint.report.TargetStudy;
import glint.report.ThinLines;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Speed against error of some scenes, and what they were measured on; immutable.
 *
 * @param command what made the report
 * @param environment what it was measured on
 * @param entries at least one
 * @param lines what renders miss of thin lines, which are in none of the scenes
 */
public record Report(
    String command, Environment environment, List<Entry> entries, List<ThinLines.Count> lines) {

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
   * @param targets what renders to an error cost and claim
   * @param depths what bounces cost and bring
   * @param replays the commands that show the worst pixels, in their order
   * @param formula how far the truth is from what a formula says, in display levels, if one does
   */
  public record Entry(
      String file,
      String name,
      String title,
      int width,
      int height,
      Curve uniform,
      TargetStudy targets,
      DepthStudy depths,
      List<String> replays,
      OptionalDouble formula) {}
}

package glint.desktop.report;

import java.util.Locale;

/** Writes a picture as SVG, in pixels from the top left. */
final class Svg {

  /** What is dark on white becomes light on black where the reader wants that. */
  private static final String STYLE =
      """
      <style>@media (prefers-color-scheme: dark) {
      [fill="#fff"] { fill: #17191c } [fill="#222"] { fill: #e2e4e8 } [fill="#777"] { fill: #9aa0a8 }
      [stroke="#e4e4e4"] { stroke: #33373d } [stroke="#999"] { stroke: #8a9098 }
      [fill="#0072b2"] { fill: #4fb0ea } [stroke="#0072b2"] { stroke: #4fb0ea }
      [fill="#d55e00"] { fill: #ff9147 } [stroke="#d55e00"] { stroke: #ff9147 }
      }</style>
      """;

  private final StringBuilder out = new StringBuilder();

  /** Begins a white picture. */
  Svg(int width, int height) {
    add(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\""
            + " height=\"%d\" font-family=\"sans-serif\" font-size=\"11\">",
        width, height, width, height);
    out.append(STYLE);
    add("<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>", width, height);
  }

  /** Begins a part of the picture that is moved. */
  void group(int right, int down) {
    add("<g transform=\"translate(%d %d)\">", right, down);
  }

  /** Ends such a part. */
  void endGroup() {
    add("</g>");
  }

  /** Writes words at a point of their base line: their start, middle or end. */
  void text(double x, double y, String anchor, String colour, String words) {
    add(
        "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>",
        x, y, anchor, colour, Html.escape(words));
  }

  /** Draws a line. */
  void line(double x0, double y0, double x1, double y1, String colour, String dashes) {
    add(
        "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-dasharray=\"%s\"/>",
        x0, y0, x1, y1, colour, dashes);
  }

  /** Draws a dot, full or hollow. */
  void dot(double x, double y, String colour, boolean full) {
    add(
        "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\" stroke=\"%s\"/>",
        x, y, full ? colour : "#fff", colour);
  }

  /** Draws one of many dots. */
  void speck(double x, double y) {
    add(
        "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2\" fill=\"%s\" fill-opacity=\".45\"/>",
        x, y, Panel.MEASURED);
  }

  /** Draws a diamond. */
  void diamond(double x, double y, String colour) {
    add("<path d=\"M%.1f %.1fl5 5l-5 5l-5 -5z\" fill=\"%s\"/>", x, y - 5, colour);
  }

  /** Ends the picture and returns it. */
  String end() {
    return out + "</svg>\n";
  }

  private void add(String format, Object... values) {
    out.append(String.format(Locale.ROOT, format, values)).append('\n');
  }
}

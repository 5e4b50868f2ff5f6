package glint.desktop.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import glint.report.Curve;
import glint.report.Errors;
import glint.report.Measurement;
import glint.report.Measurement.Cost;
import glint.report.Rays;
import glint.report.Spread;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/** The files of a report whose figures are known. */
class WritersTest {

  private static final Map<String, String> FILES = ReportFiles.of(Example.report());

  @Test
  void thePictureCarriesEveryPointAtItsPlace() throws Exception {
    Document svg = xml(FILES.get("speed-and-error-rays.svg"));
    List<Element> dots = elements(svg, "circle");
    // Two of the legend and five of the law; exact images have no logarithm.
    assertEquals(7, dots.size());
    // 1 k to 16 k rays lie on decades from 1 k to 100 k, 10 to 0.625 levels on 0.1 to 10.
    Element last = dots.get(6);
    double width = 276 - 58;
    double height = 196 - 40;
    assertEquals(58 + width * Math.log10(16) / 2, number(last, "cx"), 0.06);
    assertEquals(40 + height * Math.log10(16) / 2, number(last, "cy"), 0.06);
    assertEquals(58, number(dots.get(2), "cx"), 1e-9);
    assertEquals(40, number(dots.get(2), "cy"), 1e-9);
    // Ten times 0.125 levels are more than 10/16.
    assertEquals("#fff", last.getAttribute("fill"));
    assertEquals("#0072b2", dots.get(5).getAttribute("fill"));
  }

  @Test
  void thePictureIsLabelledAndNothingLeavesIt() throws Exception {
    Document svg = xml(FILES.get("speed-and-error-seconds.svg"));
    List<String> words = new ArrayList<>();
    double width = Double.parseDouble(svg.getDocumentElement().getAttribute("width"));
    for (Element text : elements(svg, "text")) {
      words.add(text.getTextContent());
      double left = text.getParentNode() instanceof Element group ? shift(group) : 0;
      double x = left + number(text, "x");
      double wide = 6.5 * text.getTextContent().length();
      String anchor = text.getAttribute("text-anchor");
      double start = anchor.equals("end") ? x - wide : anchor.equals("middle") ? x - wide / 2 : x;
      assertTrue(start >= 0 && start + wide <= width, text.getTextContent());
    }
    assertTrue(words.containsAll(List.of("law", "1 ms", "10 ms", "100 ms")), words::toString);
    assertTrue(words.containsAll(List.of("0.1", "1", "10")), words::toString);
    assertTrue(words.contains("2 × 32 samples, slope -1.00"), words::toString);
    assertFalse(words.contains("exact"), words::toString);
  }

  @Test
  void anAxisRunsOverWholeDecades() {
    LogAxis axis = LogAxis.around(2e-9, 3e4, power -> "");
    assertEquals(-9, axis.low());
    assertEquals(5, axis.high());
    assertEquals(0.5, axis.place(1e-2), 1e-12);
    assertEquals(1, LogAxis.around(1, 1, power -> "").high());
  }

  @Test
  void linesFollowTheirLawsAndEndAtTheAxes() throws Exception {
    List<Element> lines = elements(xml(FILES.get("speed-and-error-rays.svg")), "path");
    lines.removeIf(line -> !line.hasAttribute("stroke-dasharray"));
    lines.removeIf(line -> line.getAttribute("stroke").equals("#e4e4e4"));
    // Two of the legend, then the slope -1/2 through 2 k rays and 5 levels, then the law itself.
    assertEquals(4, lines.size());
    double decade = (276 - 58) / 2.0;
    double levels = (196 - 40) / 2.0;
    double end = 58 + decade * Math.log10(16);
    assertLine(
        lines.get(2),
        58,
        40 + levels * Math.log10(Math.sqrt(2)),
        end,
        40 + levels * Math.log10(Math.sqrt(32)));
    assertLine(lines.get(3), 58, 40, end, 40 + levels * Math.log10(16));
    assertEquals("5 3", lines.get(3).getAttribute("stroke-dasharray"));
  }

  @Test
  void linesThatLeaveTheAxesAreCut() throws Exception {
    Errors first = new Errors(0.5, 0, 0, 0);
    Errors second = new Errors(0.2, 0, 0, 0);
    Spread seconds = Spread.of(1);
    List<Measurement> points =
        List.of(
            new Measurement(1, List.of(first), seconds, new Rays(1e3, 0, 0, 0), true),
            new Measurement(2, List.of(second), seconds, new Rays(1e5, 0, 0, 0), true));
    Curve law = Example.report().entries().get(0).uniform();
    Curve curve = new Curve(law.truth(), points, 0, true);
    Report.Entry entry = Example.entry("f", "n".repeat(99), "t", curve, 0);
    Document svg = xml(PanelChart.of(List.of(entry), Cost.RAYS).orElseThrow());
    List<Element> lines = elements(svg, "path");
    lines.removeIf(line -> !line.hasAttribute("stroke-dasharray"));
    lines.removeIf(line -> line.getAttribute("stroke").equals("#e4e4e4"));
    // The slope -1/2 through 100 k rays and 0.2 levels reaches 1 level, the top, at 4 k rays.
    double start = 58 + (276 - 58) / 2.0 * Math.log10(4);
    assertEquals(3, lines.size());
    assertLine(lines.get(2), start, 40, 276, 40 + (196 - 40) * Math.log10(5));
    // A name that is too long for its chart is cut, too.
    assertEquals("n".repeat(34) + "…", elements(svg, "text").get(6).getTextContent());
  }

  @Test
  void withoutAnErrorThereIsNothingToDraw() {
    Report report = Example.report();
    List<Report.Entry> exact = report.entries().subList(1, 2);
    assertTrue(PanelChart.of(exact, Cost.RAYS).isEmpty());
    Report one = new Report("", report.environment(), exact, report.lines());
    Set<String> files =
        Set.of(
            "speed-and-error.json",
            "speed-and-error.md",
            "speed-and-error.html",
            "speed-and-error-reliability.svg");
    assertEquals(files, ReportFiles.of(one).keySet());
  }

  @Test
  void thePageIsWellFormedAndNeedsNoOtherFile() throws Exception {
    String html = FILES.get("speed-and-error.html");
    Document page = xml(html.replace("<!DOCTYPE html>", ""));
    assertEquals(3, elements(page, "svg").size());
    assertEquals(5, elements(page, "details").size());
    assertEquals("Speed against error", elements(page, "title").get(0).getTextContent());
    assertFalse(html.contains("src=") || html.contains("href="), html);
    String machine = elements(page, "p").get(0).getTextContent().trim();
    assertEquals(
        "Made by glint report a: Glint 9.9, commit abc1234, Some JVM, Some machine <1 & only>, 2 threads.",
        machine);
    for (Element table : elements(page, "table")) {
      int columns = table.getElementsByTagName("th").getLength();
      int rows = table.getElementsByTagName("tr").getLength() - 1;
      assertEquals(columns * rows, table.getElementsByTagName("td").getLength());
    }
  }

  @Test
  void theMarkdownShowsTheFiguresAndTheCharts() {
    String text = FILES.get("speed-and-error.md");
    List<String> lines = text.lines().toList();
    String law =
        "| law | 2 × 32 samples | 0.125 | – | 10 | 2.5 | (0.625) | -1.00 (-1.00 to -1.00) |";
    assertTrue(lines.contains(law), text);
    assertTrue(lines.contains("| exact | exact mean | 0 | 0.5 | 0 | 0 | 0 | – |"), text);
    String cost = "| law | 8x6 | 50 % | 30 % | 0 % | 20 % | 1 M | 1 ms | 0.25 |";
    assertTrue(lines.contains(cost), text);
    assertTrue(
        lines.contains("| 4 | 2.5 | 5 | 9.80e-03 | 2.50e-02 | 4 ms | 2 ms | 8 ms | 4 k |"), text);
    for (String file : List.of("speed-and-error-seconds.svg", "speed-and-error-rays.svg")) {
      assertTrue(text.contains("](" + file + ")"), text);
      assertTrue(FILES.containsKey(file));
    }
    assertTrue(text.contains("<summary>exact (b.yaml); the time limit ended it</summary>"), text);
  }

  @Test
  void theDataHoldAllFigures() {
    String json = FILES.get("speed-and-error.json");
    JsonObject report = JsonParser.parseString(json).getAsJsonObject();
    assertEquals("abc1234", report.getAsJsonObject("environment").get("commit").getAsString());
    JsonArray scenes = report.getAsJsonArray("scenes");
    JsonObject law = scenes.get(0).getAsJsonObject();
    assertEquals(0.125, law.getAsJsonObject("truth").get("uncertainty").getAsDouble());
    JsonObject uniform = law.getAsJsonObject("uniform");
    JsonObject point = uniform.getAsJsonArray("points").get(3).getAsJsonObject();
    assertEquals(8, point.get("samples").getAsInt());
    assertEquals(1.25, point.getAsJsonObject("error").get("levels").getAsDouble());
    assertEquals(8e-3, point.getAsJsonObject("seconds").get("median").getAsDouble());
    assertEquals(1600, point.getAsJsonObject("rays").get("shadow").getAsDouble());
    assertEquals(2, point.getAsJsonArray("runs").size());
    assertTrue(point.get("trusted").getAsBoolean());
    assertEquals(-1, uniform.getAsJsonObject("raySlope").get("value").getAsDouble(), 1e-12);
    JsonObject exact = scenes.get(1).getAsJsonObject().getAsJsonObject("uniform");
    assertTrue(exact.get("raySlope").isJsonNull());
    assertFalse(exact.get("complete").getAsBoolean());
  }

  @Test
  void figuresHaveThreeDigitsAndAPrefix() {
    assertEquals("12.3 ms", Numbers.prefixed(0.01234, "s"));
    assertEquals("1 s", Numbers.prefixed(1, "s"));
    assertEquals("1.00 k", Numbers.prefixed(999.7, ""));
    assertEquals("250 M", Numbers.prefixed(2.5e8, ""));
    assertEquals("0.000123", Numbers.digits(0.000123456));
  }

  private static void assertLine(Element line, double x0, double y0, double x1, double y1) {
    String[] ends = line.getAttribute("d").split("[ML ]");
    double[] wanted = {x0, y0, x1, y1};
    for (int i = 0; i < 4; i++) {
      assertEquals(wanted[i], Double.parseDouble(ends[i + 1]), 0.06, line.getAttribute("d"));
    }
  }

  private static double shift(Element group) {
    String transform = group.getAttribute("transform");
    return transform.isEmpty() ? 0 : Double.parseDouble(transform.split("[( ]")[1]);
  }

  private static double number(Element element, String attribute) {
    return Double.parseDouble(element.getAttribute(attribute));
  }

  private static Document xml(String text) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(text)));
  }

  private static List<Element> elements(Document document, String name) {
    NodeList nodes = document.getElementsByTagName(name);
    List<Element> elements = new ArrayList<>();
    for (int i = 0; i < nodes.getLength(); i++) {
      elements.add((Element) nodes.item(i));
    }
    return elements;
  }
}

package glint.desktop.report;

import java.util.List;

/** Writes a page as HTML that needs no other file and is well-formed XML, too. */
final class Html {

  private static final String STYLE =
      """
      :root { color-scheme: light dark; --ink: #222; --paper: #fff; --rule: #ddd; --tint: #f4f5f7; }
      @media (prefers-color-scheme: dark) { :root { --ink: #e2e4e8; --paper: #17191c; --rule: #3a3f46; --tint: #22262b; } }
      body { font: 15px/1.5 sans-serif; color: var(--ink); background: var(--paper); max-width: 70em; margin: 2em auto; padding: 0 1em; }
      table { border-collapse: collapse; margin: 1em 0; font-size: 13px; }
      th, td { padding: .2em .5em; border-bottom: 1px solid var(--rule); text-align: right; white-space: nowrap; }
      th:first-child, td:first-child { text-align: left; }
      tr:hover td { background: var(--tint); }
      code { background: var(--tint); padding: 0 .25em; border-radius: 3px; }
      details { margin: .4em 0; }
      summary { cursor: pointer; }
      figure { margin: 1em 0; }
      svg { width: 100%; height: auto; }
      .wide { overflow-x: auto; }
      """;

  private Html() {}

  /** Returns the page; its title is its first heading. */
  static String of(List<Block> page) {
    StringBuilder out = new StringBuilder("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n");
    out.append("<meta charset=\"utf-8\"/>\n<title>");
    out.append(escape(((Block.Heading) page.get(0)).text()));
    out.append("</title>\n<style>\n").append(STYLE).append("</style>\n</head>\n<body>\n");
    page.forEach(block -> add(block, out));
    return out.append("</body>\n</html>\n").toString();
  }

  /** Returns text as it stands in XML. */
  static String escape(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }

  private static void add(Block block, StringBuilder out) {
    if (block instanceof Block.Heading heading) {
      element("h" + heading.level(), heading.text(), out);
    } else if (block instanceof Block.Paragraph paragraph) {
      element("p", paragraph.text(), out);
    } else if (block instanceof Block.Figure figure) {
      out.append("<figure>\n").append(figure.svg());
      element("figcaption", figure.caption(), out);
      out.append("</figure>\n");
    } else if (block instanceof Block.Details details) {
      out.append("<details>");
      element("summary", details.summary(), out);
      add(details.grid(), out);
      out.append("</details>\n");
    } else if (block instanceof Block.Grid grid) {
      out.append("<div class=\"wide\"><table>\n<tr>");
      grid.head().forEach(cell -> element("th", cell, out));
      out.append("</tr>\n");
      for (List<String> row : grid.rows()) {
        out.append("<tr>");
        row.forEach(cell -> element("td", cell, out));
        out.append("</tr>\n");
      }
      out.append("</table></div>\n");
    }
  }

  private static void element(String name, String text, StringBuilder out) {
    String inline = escape(text).replaceAll("`([^`]*)`", "<code>$1</code>");
    out.append("<" + name + ">").append(inline).append("</" + name + ">\n");
  }
}

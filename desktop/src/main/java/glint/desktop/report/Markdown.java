package glint.desktop.report;

import java.util.List;

/** Writes a page as Markdown, as code hosts show it. */
final class Markdown {

  private Markdown() {}

  /** Returns the page. */
  static String of(List<Block> page) {
    StringBuilder out = new StringBuilder();
    for (Block block : page) {
      if (out.length() > 0) {
        out.append('\n');
      }
      add(block, out);
    }
    return out.toString();
  }

  private static void add(Block block, StringBuilder out) {
    if (block instanceof Block.Heading heading) {
      out.append("#".repeat(heading.level())).append(' ').append(heading.text()).append('\n');
    } else if (block instanceof Block.Paragraph paragraph) {
      out.append(paragraph.text()).append('\n');
    } else if (block instanceof Block.Figure figure) {
      out.append("![" + figure.caption() + "](" + figure.file() + ")\n");
    } else if (block instanceof Block.Details details) {
      out.append("<details><summary>" + Html.escape(details.summary()) + "</summary>\n\n");
      add(details.grid(), out);
      out.append("\n</details>\n");
    } else if (block instanceof Block.Grid grid) {
      row(grid.head(), out);
      out.append("|---".repeat(grid.head().size())).append("|\n");
      grid.rows().forEach(row -> row(row, out));
    }
  }

  private static void row(List<String> cells, StringBuilder out) {
    for (String cell : cells) {
      out.append("| ").append(cell.replace("|", "\\|")).append(' ');
    }
    out.append("|\n");
  }
}

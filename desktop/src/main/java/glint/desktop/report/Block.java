package glint.desktop.report;

import java.util.List;

/** A part of a page. Words between backticks are code. */
sealed interface Block {

  /** A heading; level 1 is the page's own. */
  record Heading(int level, String text) implements Block {}

  /** A paragraph. */
  record Paragraph(String text) implements Block {}

  /** A table; every row has as many cells as the head. */
  record Grid(List<String> head, List<List<String>> rows) implements Block {}

  /** A picture: its file, for pages that refer to it, and its SVG, for pages that hold it. */
  record Figure(String file, String caption, String svg) implements Block {}

  /** A table that is shown when somebody asks for it. */
  record Details(String summary, Grid grid) implements Block {}
}

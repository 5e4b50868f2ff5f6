/**
 * The report of {@code glint report} as a page with charts and as data.
 *
 * <p>Reading order: Report, ReportPage, Block, Markdown, Html, PanelChart, ReportJson.
 */
package glint.desktop.report;

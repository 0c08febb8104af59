package robosim.geometry.report.speed;

import java.util.List;
import robosim.geometry.report.speed.Page.Block;
import robosim.geometry.report.speed.Page.Code;
import robosim.geometry.report.speed.Page.Heading;
import robosim.geometry.report.speed.Page.Paragraph;
import robosim.geometry.report.speed.Page.Picture;
import robosim.geometry.report.speed.Page.Table;

/** A page as Markdown; its pictures are files beside it or in a folder. */
final class Markdown {
    private Markdown() {}

    static String write(Page page, String pictures) {
        StringBuilder out = new StringBuilder();
        for (Block block : page.blocks()) {
            if (block instanceof Heading heading) {
                out.append("#".repeat(heading.level())).append(' ').append(heading.text());
            } else if (block instanceof Paragraph paragraph) {
                out.append(paragraph.text());
            } else if (block instanceof Picture picture) {
                out.append("![").append(picture.figure().title()).append("](").append(pictures);
                out.append(picture.figure().name()).append(".svg)");
            } else if (block instanceof Table table) {
                table(table, out);
            } else if (block instanceof Code code) {
                out.append("```\n").append(code.text()).append("\n```");
            }
            out.append("\n\n");
        }
        return out.toString().stripTrailing() + "\n";
    }

    private static void table(Table table, StringBuilder out) {
        row(table.head(), out);
        for (int column = 0; column < table.head().size(); column++) {
            out.append(isNumber(table, column) ? "|--:" : "|---");
        }
        out.append("|\n");
        table.rows().forEach(row -> row(row, out));
        out.setLength(out.length() - 1);
    }

    private static void row(List<String> cells, StringBuilder out) {
        cells.forEach(cell -> out.append("| ").append(cell.replace("|", "\\|")).append(' '));
        out.append("|\n");
    }

    /** Whether a column holds numbers, which stand on the right. */
    static boolean isNumber(Table table, int column) {
        return table.rows().stream()
                .map(row -> row.get(column))
                .allMatch(cell ->
                        cell.isEmpty() || cell.matches("(\\*\\*)?[\\-\u2013\u2212\u2264<>]?\\s?[0-9].*|\u2013"));
    }
}

package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Figure;

/** A page as Markdown, part by part; its pictures are files beside it or in a folder. */
final class Page {
    private final StringBuilder out = new StringBuilder();
    private final List<Figure> figures = new ArrayList<>();
    private final String folder;

    /** Takes the folder of the pictures as seen from the page: empty, or ending in a slash. */
    Page(String folder) {
        this.folder = folder;
    }

    List<Figure> figures() {
        return figures;
    }

    String text() {
        return out.toString().stripTrailing() + "\n";
    }

    void heading(int level, String text) {
        paragraph("#".repeat(level) + " " + text);
    }

    void paragraph(String text) {
        out.append(text).append("\n\n");
    }

    void picture(Figure figure) {
        figures.add(figure);
        paragraph("![" + figure.title() + "](" + folder + figure.name() + ".svg)");
    }

    void code(String text) {
        paragraph("```\n" + text + "\n```");
    }

    /** Columns of numbers are aligned to the right. */
    void table(List<String> head, List<List<String>> rows) {
        row(head);
        for (int k = 0; k < head.size(); k++) {
            int column = k;
            out.append(rows.stream().allMatch(row -> isNumber(row.get(column))) ? "|--:" : "|---");
        }
        out.append("|\n");
        rows.forEach(this::row);
        out.append('\n');
    }

    private void row(List<String> cells) {
        cells.forEach(cell -> out.append("| ").append(cell.replace("|", "\\|")).append(' '));
        out.append("|\n");
    }

    private static boolean isNumber(String cell) {
        return cell.isEmpty() || cell.matches("(\\*\\*)?[\\-\u2013\u2212\u2264<>]?\\s?[0-9].*|\u2013");
    }
}

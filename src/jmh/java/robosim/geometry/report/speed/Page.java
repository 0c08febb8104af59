package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Figure;

/** What a report says, part by part, whatever it is written as. Text may hold {@code code} between back quotes. */
final class Page {
    /** A part of a page. */
    sealed interface Block {}

    record Heading(int level, String text) implements Block {}

    record Paragraph(String text) implements Block {}

    record Picture(Figure figure) implements Block {}

    /** Cells that begin with a digit stand on the right. */
    record Table(List<String> head, List<List<String>> rows) implements Block {
        Table {
            head = List.copyOf(head);
            rows = List.copyOf(rows);
        }
    }

    record Code(String text) implements Block {}

    private final List<Block> blocks = new ArrayList<>();

    List<Block> blocks() {
        return blocks;
    }

    List<Figure> figures() {
        return blocks.stream()
                .filter(Picture.class::isInstance)
                .map(block -> ((Picture) block).figure())
                .toList();
    }

    void heading(int level, String text) {
        blocks.add(new Heading(level, text));
    }

    void paragraph(String text) {
        blocks.add(new Paragraph(text));
    }

    void picture(Figure figure) {
        blocks.add(new Picture(figure));
    }

    void table(List<String> head, List<List<String>> rows) {
        blocks.add(new Table(head, rows));
    }

    void code(String text) {
        blocks.add(new Code(text));
    }
}

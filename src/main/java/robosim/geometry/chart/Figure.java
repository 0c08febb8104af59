package robosim.geometry.chart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import robosim.geometry.check.Text;

/**
 * A picture of panels that share a legend.
 *
 * @param name    of its file, without an ending
 * @param caption what is measured, and what the signs mean; below the panels
 * @param columns how many panels stand side by side
 * @param height  of the plot of a panel
 */
public record Figure(String name, String title, String caption, List<Panel> panels, int columns, int height) {
    static final int WIDTH = 960;
    private static final int MARGIN = 24;
    private static final double TITLE_SIZE = 19;

    /** How much wider bold letters are. */
    private static final double BOLD = 1.08;

    private static final double LEGEND_SIZE = 13;
    private static final double CAPTION_SIZE = 12.5;
    private static final double CAPTION_LINE = 18;

    /** Keeps a copy of the panels. */
    public Figure {
        panels = List.copyOf(panels);
    }

    /** The picture, which needs nothing else. */
    public String svg() {
        StringBuilder body = new StringBuilder();
        double y = 36;
        for (String line : TextWidths.wrap(title, BOLD * TITLE_SIZE, WIDTH - 2.0 * MARGIN)) {
            body.append(
                    text(MARGIN, y, TITLE_SIZE, "ink", "start", line).replace("<text", "<text font-weight=\"600\""));
            y += 25;
        }
        y = legend(body, y);
        int rows = (panels.size() + columns - 1) / columns;
        double cell = (WIDTH - 2.0 * MARGIN + 16) / columns - 16;
        for (int k = 0; k < panels.size(); k++) {
            double left = MARGIN + (k % columns) * (cell + 16);
            int row = k / columns;
            double top = y + row * rowHeight();
            PanelPainter.paint(panels.get(k), left, top, cell, height, body);
        }
        y += rows * rowHeight() + 14;
        for (String line : TextWidths.wrap(caption.replace("`", ""), CAPTION_SIZE, WIDTH - 2.0 * MARGIN)) {
            body.append(text(MARGIN, y, CAPTION_SIZE, "faint", "start", line));
            y += CAPTION_LINE;
        }
        long bottom = Math.round(y + 8);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"rg\" viewBox=\"0 0 " + WIDTH + " " + bottom
                + "\" width=\"" + WIDTH + "\" height=\"" + bottom + "\" role=\"img\">\n<title>" + Text.xml(title)
                + "</title>\n<desc>" + Text.xml(caption) + "</desc>\n<style>\n" + Style.css() + "</style>\n"
                + "<rect class=\"ground\" width=\"" + WIDTH + "\" height=\"" + bottom + "\"/>\n" + body + "</svg>\n";
    }

    private double rowHeight() {
        return height + PanelPainter.ABOVE + PanelPainter.BELOW;
    }

    /** One line a look, in rows; answers where the panels begin. */
    private double legend(StringBuilder body, double top) {
        Map<String, Series> looks = new LinkedHashMap<>();
        for (Panel panel : panels) {
            panel.series().stream()
                    .filter(series -> !series.name().isEmpty())
                    .forEach(series -> looks.putIfAbsent(series.look(), series));
        }
        if (looks.size() < 2) {
            return top - 8;
        }
        double x = MARGIN;
        double y = top;
        for (Series series : new ArrayList<>(looks.values())) {
            double width = 34 + TextWidths.width(series.name(), LEGEND_SIZE) + 20;
            if (x + width > WIDTH - MARGIN && x > MARGIN) {
                x = MARGIN;
                y += 22;
            }
            SeriesPainter.sample(series, x, y - 4.5, body);
            body.append(text(x + 34, y, LEGEND_SIZE, "ink", "start", series.name()));
            x += width;
        }
        return y + 12;
    }

    static String text(double x, double y, double size, String style, String anchor, String words) {
        return String.format(
                Locale.ROOT,
                "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%s\" class=\"%s\" text-anchor=\"%s\">%s</text>\n",
                x,
                y,
                size == Math.rint(size) ? Integer.toString((int) size) : Double.toString(size),
                style,
                anchor,
                Text.xml(words));
    }
}

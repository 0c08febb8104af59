package robosim.geometry.chart;

import java.util.Locale;

/** Draws the series of a panel: lines below, markers above them, words where there is room. */
final class SeriesPainter {
    private static final double RADIUS = 5;
    private static final double SIZE = 12;

    private final Panel panel;
    private final Labels.Place plot;
    private final StringBuilder out;
    private final Labels labels;

    SeriesPainter(Panel panel, Labels.Place plot, StringBuilder out) {
        this.panel = panel;
        this.plot = plot;
        this.out = out;
        this.labels = new Labels(new Labels.Place(plot.left(), plot.top(), plot.right() + 4, plot.bottom() - 1));
    }

    void paint() {
        for (Series series : panel.series()) {
            if (series.line() == Series.Line.BARS) {
                bars(series);
            } else if (series.line() != Series.Line.NONE) {
                line(series);
            }
        }
        for (Series series : panel.series()) {
            for (Series.Dot dot : series.dots()) {
                if (dot.margin() > 0) {
                    margin(series, dot);
                }
                if (series.line() != Series.Line.BARE && series.line() != Series.Line.BARS) {
                    out.append(series.marker().draw(x(dot), y(dot), RADIUS, style(series)));
                    labels.take(x(dot), y(dot), RADIUS + 1);
                }
            }
        }
        for (Series series : panel.series()) {
            for (Series.Dot dot : series.dots()) {
                if (!dot.label().isEmpty() && series.line() != Series.Line.BARS) {
                    write(series, dot);
                }
            }
        }
    }

    private double x(Series.Dot dot) {
        return plot.left() + panel.x().at(dot.x()) * (plot.right() - plot.left());
    }

    private double y(Series.Dot dot) {
        return y(dot.y());
    }

    private double y(double value) {
        return plot.bottom() - panel.y().at(value) * (plot.bottom() - plot.top());
    }

    private void margin(Series series, Series.Dot dot) {
        out.append(String.format(
                Locale.ROOT,
                "<path class=\"s%d\" stroke-width=\"1.5\" d=\"M%.1f %.1fV%.1f\"/>\n",
                series.colour(),
                x(dot),
                y(dot.y() - dot.margin()),
                y(dot.y() + dot.margin())));
    }

    private void line(Series series) {
        StringBuilder d = new StringBuilder();
        double lastX = 0;
        double lastY = 0;
        for (Series.Dot dot : series.dots()) {
            d.append(String.format(Locale.ROOT, "%s%.1f %.1f", d.length() == 0 ? "M" : "L", x(dot), y(dot)));
            if (d.indexOf("L") > 0) {
                labels.takeLine(lastX, lastY, x(dot), y(dot));
            }
            lastX = x(dot);
            lastY = y(dot);
        }
        out.append(stroke(series, d.toString()));
    }

    private static String stroke(Series series, String d) {
        String dash = series.line() == Series.Line.DASHED ? " stroke-dasharray=\"5 4\"" : "";
        return "<path class=\"s" + series.colour() + "\" stroke-width=\"2\"" + dash + " d=\"" + d + "\"/>\n";
    }

    private void bars(Series series) {
        double thick = Math.min(
                20, (plot.bottom() - plot.top()) / Math.max(1, panel.y().ticks().size()) * 0.62);
        for (Series.Dot dot : series.dots()) {
            out.append(String.format(
                    Locale.ROOT,
                    "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
                    (series.hollow() ? "h" : "f") + series.colour(),
                    plot.left(),
                    y(dot) - thick / 2,
                    x(dot) - plot.left(),
                    thick));
            double width = TextWidths.width(dot.label(), SIZE);
            boolean fits = x(dot) + 6 + width < plot.right();
            out.append(Figure.text(
                    fits ? x(dot) + 6 : plot.left() + 6,
                    y(dot) + 4,
                    SIZE,
                    fits ? "ink" : "ground",
                    "start",
                    dot.label()));
        }
    }

    private void write(Series series, Series.Dot dot) {
        double width = TextWidths.width(dot.label(), SIZE);
        Labels.Place place = labels.find(x(dot), y(dot), width, SIZE + 1);
        if (place != null) {
            out.append(
                    Figure.text(place.left(), place.bottom() - 3, SIZE, "t" + series.colour(), "start", dot.label()));
        }
    }

    private static String style(Series series) {
        boolean isOpen =
                series.marker() == Marker.CROSS || series.marker() == Marker.PLUS || series.marker() == Marker.BAR;
        String fill = isOpen ? "s" : series.hollow() ? "h" : "f";
        return fill + series.colour() + (isOpen || series.hollow() ? "\" stroke-width=\"2" : "");
    }

    /** A look for the legend. */
    static void sample(Series series, double x, double y, StringBuilder out) {
        if (series.line() == Series.Line.BARS) {
            out.append(String.format(
                    Locale.ROOT,
                    "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"24\" height=\"11\"/>\n",
                    (series.hollow() ? "h" : "f") + series.colour(),
                    x,
                    y - 5.5));
            return;
        }
        if (series.line() != Series.Line.NONE) {
            out.append(stroke(series, String.format(Locale.ROOT, "M%.1f %.1fh26", x, y)));
        }
        if (series.line() != Series.Line.BARE) {
            out.append(series.marker().draw(x + 13, y, RADIUS, style(series)));
        }
    }
}

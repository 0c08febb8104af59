package robosim.geometry.chart;

import java.util.Locale;

/** Draws a panel: its frame and marks, then its series. */
final class PanelPainter {
    /** Room above a plot for its title, and below it for the axis. */
    static final int ABOVE = 34;

    static final int BELOW = 52;

    /** Room for half of the last mark's words. */
    private static final double RIGHT = 18;

    private static final double SMALL = 12;

    private PanelPainter() {}

    static void paint(Panel panel, double left, double top, double width, double height, StringBuilder out) {
        double names = panel.y().ticks().stream()
                .mapToDouble(tick -> TextWidths.width(tick.label(), SMALL))
                .max()
                .orElse(0);
        boolean isTitled = !panel.y().title().isEmpty();
        Labels.Place plot = new Labels.Place(
                left + Math.max(30, names + 10) + (isTitled ? 20 : 0),
                top + ABOVE,
                left + width - RIGHT,
                top + ABOVE + height);
        if (!panel.title().isEmpty()) {
            out.append(Figure.text(plot.left(), top + ABOVE - 11, 14, "ink", "start", panel.title())
                    .replace("<text", "<text font-weight=\"600\""));
        }
        breaks(panel, plot, out);
        across(panel.x(), plot, out);
        up(panel.y(), plot, out);
        out.append(String.format(
                Locale.ROOT,
                "<path class=\"frame\" d=\"M%.1f %.1fV%.1fH%.1f\"/>\n",
                plot.left(),
                plot.top(),
                plot.bottom(),
                plot.right()));
        out.append(Figure.text(
                (plot.left() + plot.right()) / 2,
                plot.bottom() + 40,
                13,
                "ink",
                "middle",
                panel.x().title()));
        if (isTitled) {
            double x = left + 12;
            double y = (plot.top() + plot.bottom()) / 2;
            out.append(Figure.text(x, y, 13, "ink", "middle", panel.y().title())
                    .replace("<text", String.format(Locale.ROOT, "<text transform=\"rotate(-90 %.1f %.1f)\"", x, y)));
        }
        new SeriesPainter(panel, plot, out).paint();
    }

    /** Strips of zeros are tinted. */
    private static void breaks(Panel panel, Labels.Place plot, StringBuilder out) {
        double wide = plot.right() - plot.left();
        double tall = plot.bottom() - plot.top();
        if (!panel.x().breaks().isEmpty()) {
            double to = panel.x().breaks().get(panel.x().breaks().size() - 1);
            double from = panel.x().breaks().size() > 1 ? panel.x().breaks().get(0) : 0;
            band(plot.left() + from * wide, plot.top(), (to - from) * wide, tall, out);
        }
        if (!panel.y().breaks().isEmpty()) {
            double strip = panel.y().breaks().get(0) * tall;
            band(plot.left(), plot.bottom() - strip, wide, strip, out);
        }
    }

    private static void band(double x, double y, double width, double height, StringBuilder out) {
        out.append(String.format(
                Locale.ROOT,
                "<rect class=\"band\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
                x,
                y,
                width,
                height));
    }

    private static void across(Axis axis, Labels.Place plot, StringBuilder out) {
        double free = plot.left() - 100;
        for (Axis.Tick tick : axis.ticks()) {
            double x = plot.left() + tick.at() * (plot.right() - plot.left());
            if (tick.line()) {
                line("grid", x, plot.top(), x, plot.bottom(), out);
            }
            line("frame", x, plot.bottom(), x, plot.bottom() + (tick.label().isEmpty() ? 3 : 6), out);
            double half = TextWidths.width(tick.label(), SMALL) / 2 + 3;
            // A mark keeps its line where its words have no room.
            if (!tick.label().isEmpty() && x - half >= free) {
                out.append(Figure.text(x, plot.bottom() + 20, SMALL, "faint", "middle", tick.label()));
                free = x + half;
            }
        }
    }

    private static void up(Axis axis, Labels.Place plot, StringBuilder out) {
        for (Axis.Tick tick : axis.ticks()) {
            double y = plot.bottom() - tick.at() * (plot.bottom() - plot.top());
            if (tick.line()) {
                line("grid", plot.left(), y, plot.right(), y, out);
            }
            if (axis.isScale()) {
                line("frame", plot.left() - (tick.label().isEmpty() ? 3 : 6), y, plot.left(), y, out);
            }
            if (!tick.label().isEmpty()) {
                out.append(Figure.text(plot.left() - 10, y + 4, SMALL, "faint", "end", tick.label()));
            }
        }
    }

    private static void line(String style, double x1, double y1, double x2, double y2, StringBuilder out) {
        out.append(String.format(
                Locale.ROOT,
                "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n",
                style,
                x1,
                y1,
                x2,
                y2));
    }
}

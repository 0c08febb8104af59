package robosim.geometry.sweep;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.Checks;

/**
 * Results as an SVG plot: a panel for each number with its mean over the values of one parameter, the one with the most
 * numeric values, and a line for each world and combination of the other parameters. Error bars are the interval of
 * {@link SweepSummary.Spread#margin()}. If no parameter varies, the worlds are shown side by side. A number that is the
 * same everywhere is shown as a line of text.
 */
public final class SweepPlot {
    private static final int WIDTH = 760;
    private static final int PANEL = 250;
    private static final int LEFT = 90;
    private static final int RIGHT = 20;
    private static final int TOP = 60;
    private static final int BELOW = 60;
    private static final int LEGEND_ROW = 18;

    /** Distinguishable for colour-blind readers too: Okabe and Ito 2008. */
    private static final String[] COLOURS = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"
    };

    private final SweepSummary summary;
    private final String title;
    private final @Nullable String along;
    private final List<String> places = new ArrayList<>();
    private final Map<String, Map<String, Map<String, SweepSummary.Spread>>> lines = new LinkedHashMap<>();
    private final StringBuilder svg = new StringBuilder();

    private SweepPlot(SweepHeader header, SweepSummary summary) {
        this.summary = summary;
        along = longest(header);
        title = header.scenario().substring(header.scenario().lastIndexOf('.') + 1) + ", "
                + header.replicates() + (header.replicates() == 1 ? " replicate" : " replicates")
                + " each: means and their 95 % intervals";
        summary.cells().forEach(this::sort);
        if (along != null) {
            places.sort((a, b) -> Double.compare(Double.parseDouble(a), Double.parseDouble(b)));
        }
    }

    /** The plot as SVG. */
    public static String svg(SweepHeader header, SweepSummary summary) {
        Checks.present("header", header);
        Checks.present("summary", summary);
        SweepPlot plot = new SweepPlot(header, summary);
        plot.draw();
        return plot.svg.toString();
    }

    /** The parameter with the most values, all of them numbers; null if none has two. */
    private static @Nullable String longest(SweepHeader header) {
        String best = null;
        int most = 1;
        for (Map.Entry<String, String> parameter : header.parameters().entrySet()) {
            String[] values = parameter.getValue().split(",", -1);
            if (values.length > most && isNumeric(values)) {
                best = parameter.getKey();
                most = values.length;
            }
        }
        return best;
    }

    private static boolean isNumeric(String[] values) {
        for (String value : values) {
            try {
                if (!Double.isFinite(Double.parseDouble(value))) {
                    return false;
                }
            } catch (NumberFormatException e) {
                return false;
            }
        }
        return true;
    }

    private void sort(SweepSummary.Cell cell, Map<String, SweepSummary.Spread> spreads) {
        Map<String, String> others = new TreeMap<>(cell.parameters());
        String place = along == null ? cell.world() + text(others) : String.valueOf(others.remove(along));
        String line = along == null ? "" : cell.world() + text(others);
        if (!places.contains(place)) {
            places.add(place);
        }
        lines.computeIfAbsent(line, key -> new LinkedHashMap<>()).put(place, spreads);
    }

    private static String text(Map<String, String> parameters) {
        StringBuilder text = new StringBuilder();
        parameters.forEach(
                (name, value) -> text.append(", ").append(name).append(' ').append(value));
        return text.toString();
    }

    private void draw() {
        List<String> numbers = summary.cells().values().stream()
                .flatMap(spreads -> spreads.keySet().stream())
                .distinct()
                .toList();
        List<String> same = numbers.stream().filter(this::isOne).toList();
        List<String> panels =
                numbers.stream().filter(number -> !same.contains(number)).toList();
        int legend = (along == null ? 0 : LEGEND_ROW * lines.size()) + LEGEND_ROW * same.size();
        int height = TOP + legend + panels.size() * (PANEL + BELOW) + 10;
        add(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\""
                        + " font-family=\"sans-serif\" font-size=\"12\">",
                WIDTH, height, WIDTH, height);
        add("<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>", WIDTH, height);
        add("<text x=\"%d\" y=\"24\" font-size=\"15\">%s</text>", LEFT, escaped(title));
        int row = 0;
        for (String line : along == null ? List.<String>of() : List.copyOf(lines.keySet())) {
            double y = 44 + row * LEGEND_ROW;
            add("<circle cx=\"%d\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>", LEFT + 4, y, colour(row));
            add("<text x=\"%d\" y=\"%.1f\">%s</text>", LEFT + 14, y + 4, escaped(line));
            row++;
        }
        for (String number : same) {
            add(
                    "<text x=\"%d\" y=\"%d\">%s: %s in every replicate</text>",
                    LEFT, 48 + row++ * LEGEND_ROW, escaped(number), one(number));
        }
        for (int k = 0; k < panels.size(); k++) {
            panel(panels.get(k), TOP + legend + k * (PANEL + BELOW));
        }
        svg.append("</svg>\n");
    }

    private List<SweepSummary.Spread> all(String number) {
        List<SweepSummary.Spread> all = new ArrayList<>();
        summary.cells().values().forEach(spreads -> {
            SweepSummary.Spread spread = spreads.get(number);
            if (spread != null) {
                all.add(spread);
            }
        });
        return all;
    }

    /** Whether a number is the same in all replicates, or absent in all. */
    private boolean isOne(String number) {
        double first = all(number).get(0).min();
        return all(number).stream()
                .allMatch(spread -> spread.min() == first
                        && (spread.count() == 0 || (spread.none() == 0 && spread.max() == first)));
    }

    private String one(String number) {
        SweepSummary.Spread spread = all(number).get(0);
        return spread.count() == 0 ? "none" : SweepSummary.number(spread.min());
    }

    private static String colour(int line) {
        return COLOURS[line % COLOURS.length];
    }

    private void panel(String number, int top) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (Map<String, Map<String, SweepSummary.Spread>> line : lines.values()) {
            for (Map<String, SweepSummary.Spread> spreads : line.values()) {
                SweepSummary.Spread spread = spreads.get(number);
                if (spread != null && spread.count() > 0) {
                    low = Math.min(low, spread.mean() - spread.margin());
                    high = Math.max(high, spread.mean() + spread.margin());
                }
            }
        }
        SweepAxis vertical = new SweepAxis(low, high, top + PANEL, top);
        frame(number, top, vertical);
        SweepAxis horizontal = along == null
                ? new SweepAxis(-0.5, places.size() - 0.5, LEFT, WIDTH - RIGHT)
                : new SweepAxis(
                        Double.parseDouble(places.get(0)),
                        Double.parseDouble(places.get(places.size() - 1)),
                        LEFT,
                        WIDTH - RIGHT);
        marks(horizontal, top + PANEL);
        int row = 0;
        for (Map<String, Map<String, SweepSummary.Spread>> line : lines.values()) {
            line(line, number, row++, horizontal, vertical);
        }
    }

    private void frame(String number, int top, SweepAxis vertical) {
        for (double tick : vertical.ticks()) {
            double y = vertical.at(tick);
            add("<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" stroke=\"#dddddd\"/>", LEFT, y, WIDTH - RIGHT, y);
            add("<text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%s</text>", LEFT - 6, y + 4, vertical.label(tick));
        }
        add(
                "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" stroke=\"#444444\"/>",
                LEFT, top, WIDTH - LEFT - RIGHT, PANEL);
        add(
                "<text transform=\"translate(18 %d) rotate(-90)\" text-anchor=\"middle\">%s</text>",
                top + PANEL / 2, escaped(number));
    }

    private void marks(SweepAxis horizontal, int bottom) {
        if (along == null) {
            for (int k = 0; k < places.size(); k++) {
                mark(horizontal.at(k), bottom, places.get(k));
            }
            return;
        }
        for (double tick : horizontal.ticks()) {
            mark(horizontal.at(tick), bottom, horizontal.label(tick));
        }
        add(
                "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>",
                (LEFT + WIDTH - RIGHT) / 2, bottom + 36, escaped(along + unit(along)));
    }

    private static String unit(String parameter) {
        return switch (parameter) {
            case ScenarioSweep.PLACE, ScenarioSweep.RANGE -> " [world units]";
            case ScenarioSweep.HEADING, ScenarioSweep.AIM -> " [degrees]";
            case ScenarioSweep.SLIP -> " [share]";
            default -> "";
        };
    }

    private void mark(double x, int bottom, String label) {
        add("<line x1=\"%.1f\" y1=\"%d\" x2=\"%.1f\" y2=\"%d\" stroke=\"#444444\"/>", x, bottom, x, bottom + 5);
        add("<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%s</text>", x, bottom + 19, escaped(label));
    }

    private void line(
            Map<String, Map<String, SweepSummary.Spread>> line,
            String number,
            int row,
            SweepAxis horizontal,
            SweepAxis vertical) {
        StringBuilder points = new StringBuilder();
        for (int k = 0; k < places.size(); k++) {
            Map<String, SweepSummary.Spread> spreads = line.get(places.get(k));
            SweepSummary.Spread spread = spreads == null ? null : spreads.get(number);
            if (spread == null || spread.count() == 0) {
                continue;
            }
            // Shifted sideways so that error bars do not overlap.
            double aside = 5 * (row - (lines.size() - 1) / 2.0);
            double x = horizontal.at(along == null ? k : Double.parseDouble(places.get(k))) + aside;
            double y = vertical.at(spread.mean());
            points.append(String.format(Locale.ROOT, "%.1f,%.1f ", x, y));
            add(
                    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"1.5\"/>",
                    x,
                    vertical.at(spread.mean() - spread.margin()),
                    x,
                    vertical.at(spread.mean() + spread.margin()),
                    colour(row));
            add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>", x, y, colour(row));
        }
        if (along != null) {
            add(
                    "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\"/>",
                    points.toString().trim(), colour(row));
        }
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    private void add(String form, Object... values) {
        svg.append(String.format(Locale.ROOT, form, values)).append('\n');
    }
}

package robosim.geometry.sweep;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import robosim.geometry.chart.Axis;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.LinearAxis;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Style;
import robosim.geometry.check.Checks;
import robosim.geometry.check.NumberText;

/**
 * Results as a picture, SVG: a panel for each number, its mean over the values of the parameter with the most numeric ones,
 * a line for each world and combination of the others; bars are the interval of {@link SweepSummary.Spread#margin()}. Where
 * no parameter varies, the worlds stand side by side. A number that is one and the same everywhere gets a sentence below.
 */
final class SweepPlot {
    private static final int HEIGHT = 250;
    private static final List<Marker> MARKERS = List.of(Marker.values());

    /** How far lines are moved apart, as a share of the length of the axis. */
    private static final double ASIDE = 0.008;

    private final SweepSummary summary;
    private final String title;
    private final @Nullable String along;
    private final List<String> places = new ArrayList<>();
    private final Map<String, Map<String, Map<String, SweepSummary.Spread>>> lines = new LinkedHashMap<>();

    private SweepPlot(SweepHeader header, SweepSummary summary) {
        this.summary = summary;
        along = longest(header);
        title = header.scenario().substring(header.scenario().lastIndexOf('.') + 1) + ", "
                + NumberText.count(header.replicates(), "replicate") + " each";
        summary.cells().forEach(this::sort);
        if (along != null) {
            places.sort((a, b) -> Double.compare(Double.parseDouble(a), Double.parseDouble(b)));
        }
    }

    /** The plot as SVG. */
    static String svg(SweepHeader header, SweepSummary summary) {
        Checks.present("header", header);
        Checks.present("summary", summary);
        return new SweepPlot(header, summary).figure().svg();
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

    private Figure figure() {
        List<String> numbers = summary.cells().values().stream()
                .flatMap(spreads -> spreads.keySet().stream())
                .filter(number -> !RobotArrivals.isEnd(number))
                .distinct()
                .toList();
        StringBuilder caption = new StringBuilder("Means and their 95 % intervals.");
        List<Panel> panels = new ArrayList<>();
        for (String number : numbers) {
            if (isOne(number)) {
                caption.append(' ')
                        .append(number)
                        .append(": ")
                        .append(one(number))
                        .append(" in every replicate.");
            } else {
                panels.add(panel(number));
            }
        }
        return new Figure("", title, caption.toString(), panels, 1, HEIGHT);
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

    private Panel panel(String number) {
        Axis across = along == null
                ? new Places(places)
                : LinearAxis.around(along + unit(along), place(0), place(places.size() - 1));
        double apart = along == null ? 1 : place(places.size() - 1) - place(0);
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        List<Series> series = new ArrayList<>();
        for (Map.Entry<String, Map<String, Map<String, SweepSummary.Spread>>> line : lines.entrySet()) {
            int row = series.size();
            // Shifted sideways so that error bars do not overlap.
            double aside = ASIDE * apart * (row - (lines.size() - 1) / 2.0);
            List<Series.Dot> dots = new ArrayList<>();
            for (int k = 0; k < places.size(); k++) {
                SweepSummary.Spread spread =
                        line.getValue().getOrDefault(places.get(k), Map.of()).get(number);
                if (spread != null && spread.count() > 0) {
                    low = Math.min(low, spread.mean() - spread.margin());
                    high = Math.max(high, spread.mean() + spread.margin());
                    dots.add(new Series.Dot(place(k) + aside, spread.mean(), "", spread.margin()));
                }
            }
            Marker marker = MARKERS.get(row % MARKERS.size());
            Series.Line joined = along == null ? Series.Line.NONE : Series.Line.SOLID;
            series.add(new Series(line.getKey(), row % Style.COLOURS, marker, joined, false, dots));
        }
        return new Panel("", across, LinearAxis.around(number, low, high), series);
    }

    /** Where a place is across a panel. */
    private double place(int k) {
        return along == null ? k : Double.parseDouble(places.get(k));
    }

    /** Places side by side: the value of each is its number. */
    private record Places(List<String> names) implements Axis {
        @Override
        public String title() {
            return "";
        }

        @Override
        public double at(double place) {
            return (place + 0.5) / names.size();
        }

        @Override
        public List<Tick> ticks() {
            List<Tick> ticks = new ArrayList<>();
            for (int k = 0; k < names.size(); k++) {
                ticks.add(new Tick(at(k), names.get(k), false));
            }
            return ticks;
        }
    }

    private static String unit(String parameter) {
        return switch (parameter) {
            case ScenarioSweep.PLACE, ScenarioSweep.RANGE -> " [world units]";
            case ScenarioSweep.HEADING, ScenarioSweep.AIM -> " [degrees]";
            case ScenarioSweep.SLIP -> " [share]";
            default -> "";
        };
    }
}

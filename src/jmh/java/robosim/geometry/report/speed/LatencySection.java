package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.NamesAxis;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

/** Median, 99.9 % and worst of single questions, with more and less degenerate input. */
final class LatencySection {
    private static final String STUDY = "latency";
    private static final List<Subject> SUBJECTS = List.of(
            Subject.exact(Dimension.PLANAR),
            Subject.exact(Dimension.SPATIAL),
            Subject.peer(Subject.JTS),
            Subject.peer(Subject.DYN4J));

    private LatencySection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Single questions, and degenerate input");
        List<Panel> panels = new ArrayList<>();
        for (String query : List.of("ray", "overlap")) {
            panels.add(panel(results, query));
        }
        page.picture(new Figure(
                "latency",
                "One question by the clock: median, 99.9 % and worst",
                "1,000 generated objects. Degenerate: rays aimed at corners and discs that touch faces, to a rounding; all"
                        + " the rest is random. Each question is timed alone, the clock included ("
                        + clock(results)
                        + " for nothing). The worst is mostly what else a machine does (interrupts, the compiler, the"
                        + " collector of garbage); read it beside the others of the same run.",
                panels,
                2,
                330));
        table(results, page);
    }

    private static String clock(Results results) {
        return results.value(STUDY, Subject.peer("the clock alone"), "none", "nothing", "single ns q0.5").stream()
                .mapToObj(Words::time)
                .findFirst()
                .orElse("?");
    }

    private static String scene(double share) {
        return "degenerate " + share;
    }

    private static String name(Subject subject) {
        return subject.isModule() ? subject.dimension() : subject.engine();
    }

    private static Panel panel(Results results, String query) {
        List<String> names = new ArrayList<>();
        List<List<Dot>> dots = List.of(new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
        List<Series> series = new ArrayList<>();
        List<String> quantiles = List.of("0.5", "0.999", "1.0");
        for (Subject subject : SUBJECTS) {
            for (double share : Latency.SHARES) {
                List<Dot> bar = new ArrayList<>();
                for (int k = 0; k < 3; k++) {
                    OptionalDouble nanos =
                            results.value(STUDY, subject, scene(share), query, "single ns q" + quantiles.get(k));
                    if (nanos.isPresent()) {
                        Dot dot = new Dot(nanos.getAsDouble(), names.size(), "");
                        dots.get(k).add(dot);
                        bar.add(dot);
                    }
                }
                series.add(new Series("", 8, Marker.CIRCLE, Line.BARE, false, bar));
                names.add(name(subject) + ", "
                        + (share == 0 ? "random" : Words.percent(share).replace(".0", "")));
            }
        }
        series.add(new Series("median", 0, Marker.CIRCLE, Line.NONE, false, dots.get(0)));
        series.add(new Series("99.9 %", 1, Marker.SQUARE, Line.NONE, false, dots.get(1)));
        series.add(new Series("worst", 4, Marker.CROSS, Line.NONE, false, dots.get(2)));
        double[] all = dots.stream().flatMap(List::stream).mapToDouble(Dot::x).toArray();
        return new Panel(
                query.equals("ray") ? "ray, closest hit" : "overlap test",
                LogAxis.roomy("time of one question", all, Decades::nanos),
                new NamesAxis("", names),
                series);
    }

    private static void table(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (String query : List.of("ray", "overlap")) {
            for (Subject subject : SUBJECTS) {
                for (double share : Latency.SHARES) {
                    List<String> row = new ArrayList<>(
                            List.of(query, subject.text(), Words.percent(share).replace(".0", "")));
                    for (String quantile : List.of("0.5", "0.999", "1.0")) {
                        row.add(Words.nanos(
                                results.value(STUDY, subject, scene(share), query, "single ns q" + quantile)));
                    }
                    for (String stage : List.of("pairs of doubles share", "exact share")) {
                        OptionalDouble rate = results.value(STUDY, subject, scene(share), query, stage);
                        row.add(rate.isEmpty() ? Words.NONE : Words.percent(rate.getAsDouble()));
                    }
                    rows.add(row);
                }
            }
        }
        page.paragraph(
                "The last two columns are the fallback rate: decisions for each hundred questions that the filter"
                        + " left to pairs of doubles, and to exact arithmetic (expansions or big integers).");
        page.table(
                List.of(
                        "question",
                        "who",
                        "degenerate",
                        "median, ns",
                        "99.9 %, ns",
                        "worst, ns",
                        "to pairs of doubles",
                        "to exact arithmetic"),
                rows);
    }
}

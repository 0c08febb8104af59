package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.LinearAxis;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;
import robosim.geometry.report.chart.NamesAxis;
import robosim.geometry.report.chart.NinesAxis;
import robosim.geometry.report.speed.Distances.Aim;
import robosim.geometry.report.speed.Distances.Target;

/** Errors of distances along rays, as curves and never as means. */
final class DistancesSection {
    private static final String STUDY = "distances";

    /** Below an eighth of a unit nobody sees a difference: drawn as 0. */
    private static final double LEAST = 0.125;

    private DistancesSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Distances");
        List<Panel> panels = new ArrayList<>();
        for (Target target : List.of(Target.DISC, Target.RECTANGLE)) {
            for (Aim aim : List.of(Aim.RANDOM, Aim.GRAZING)) {
                panels.add(panel(results, target, aim));
            }
        }
        page.picture(new Figure(
                "distances",
                "Distance along a ray: how many answers are off by no more than so many units in the last place",
                "Up: the share of answers that hit; the axis is stretched towards the end, where engines differ. Across: the"
                        + " error against the distance at 80 digits, in units in the last place of the largest number in the"
                        + " question (distance or coordinate); errors below 1/8 stand in the strip of 0. Grazing rays pass an"
                        + " edge or a rim by 1e-2 down to 1e-14 of the size. Hits missed, invented or without a number have"
                        + " columns of their own in the table. dyn4j declares a tolerance of its ray test; JTS has no words"
                        + " for a ray and a disc.",
                panels,
                2,
                230));
        page.picture(new Figure(
                "distances-failures",
                "Distance along a ray: what is no distance at all",
                "Of all rays at discs and turned rectangles in the plane, random and grazing together: hits that were not"
                        + " seen, hits where there is none, and answers that are no number or an exception. JTS was asked"
                        + " about rectangles alone.",
                List.of(
                        failures(results, "missed", "hits missed"),
                        failures(results, "invented", "hits invented"),
                        failures(results, "no number", "no number or exception")),
                3,
                120));
        table(results, page);
    }

    private static Panel failures(Results results, String metric, String title) {
        List<String> names = new ArrayList<>();
        List<Dot> dots = new ArrayList<>();
        double most = 1;
        for (Subject subject : subjects(Dimension.PLANAR)) {
            double asked = sum(results, subject, "asked");
            double failed = sum(results, subject, metric);
            if (asked > 0) {
                dots.add(
                        new Dot(100 * failed / asked, names.size(), Words.count(failed) + " of " + Words.count(asked)));
                names.add(name(subject));
                most = Math.max(most, 100 * failed / asked);
            }
        }
        // Room for the words behind the longest bar.
        LinearAxis share = LinearAxis.upTo("% of what was asked", 2.2 * most);
        return new Panel(
                title,
                share,
                new NamesAxis("", names),
                List.of(new Series("", 4, Marker.SQUARE, Line.BARS, false, dots)));
    }

    private static double sum(Results results, Subject subject, String metric) {
        return results.of(STUDY).stream()
                .filter(measure ->
                        measure.subject().equals(subject) && measure.metric().equals(metric))
                .mapToDouble(Measure::value)
                .sum();
    }

    private static String name(Subject subject) {
        return subject.isModule() ? subject.isAlone() ? "filter alone" : "EXACT" : subject.engine();
    }

    private static List<Subject> subjects(Dimension dimension) {
        Subject alone = new Subject(Subject.MODULE, Accuracy.EXACT.name(), dimension.name(), "alone");
        return dimension == Dimension.PLANAR
                ? List.of(Subject.exact(dimension), alone, Subject.peer(Subject.JTS), Subject.peer(Subject.DYN4J))
                : List.of(Subject.exact(dimension), alone);
    }

    private static Panel panel(Results results, Target target, Aim aim) {
        List<Series> series = new ArrayList<>();
        for (Subject subject : subjects(target.dimension)) {
            List<Dot> dots = new ArrayList<>();
            for (double share : Ecdf.SHARES) {
                results.value(STUDY, subject, target.text, aim.text, "ulp q" + share)
                        .ifPresent(ulps -> dots.add(new Dot(ulps < LEAST ? 0 : ulps, share, "")));
            }
            String name = subject.isModule()
                    ? subject.isAlone() ? "this module, filter alone" : "this module, EXACT"
                    : subject.engine();
            if (!dots.isEmpty()) {
                Look look = subject.isAlone() ? new Look(3, Marker.PLUS, false) : Look.of(subject);
                series.add(look.series(name, subject.isAlone() ? Line.DASHED : Line.SOLID, dots));
            }
        }
        return new Panel(
                target.text + ", " + aim.text,
                new LogAxis("error, units in the last place", -1, 16, true, Decades::plain),
                new NinesAxis("answers off by no more", 4),
                series);
    }

    private static void table(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (Target target : Target.values()) {
            for (Aim aim : Aim.values()) {
                for (Subject subject : subjects(target.dimension)) {
                    row(results, target, aim, subject, rows);
                }
            }
        }
        page.table(
                List.of(
                        "ray at",
                        "aim",
                        "who",
                        "asked",
                        "median",
                        "99 %",
                        "99.9 %",
                        "most, ulp",
                        "hits missed",
                        "hits invented",
                        "no number"),
                rows);
    }

    private static void row(Results results, Target target, Aim aim, Subject subject, List<List<String>> rows) {
        OptionalDouble asked = results.value(STUDY, subject, target.text, aim.text, "asked");
        if (asked.isEmpty()) {
            return;
        }
        List<String> row =
                new ArrayList<>(List.of(target.text, aim.text, subject.text(), Words.count(asked.getAsDouble())));
        for (double share : new double[] {0.5, 0.99, 0.999, 1}) {
            row.add(Words.size(results.value(STUDY, subject, target.text, aim.text, "ulp q" + share)));
        }
        for (String count : List.of("missed", "invented", "no number")) {
            row.add(Words.size(results.value(STUDY, subject, target.text, aim.text, count)));
        }
        rows.add(row);
    }
}

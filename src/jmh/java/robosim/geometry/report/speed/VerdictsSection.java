package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.PercentAxis;
import robosim.geometry.report.chart.SignedLogAxis;

/** Verdicts against the true signed gap. */
final class VerdictsSection {
    private VerdictsSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Verdicts");
        List<Panel> panels = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            panels.add(panel(results, dimension));
        }
        page.picture(new Figure(
                "verdicts",
                "Wrong verdicts against the true gap: false-free to the left of touch, false-collide to the right",
                "Pairs of objects about 1 wide, placed at gaps and depths of every decade; the gap is worked out from the"
                        + " stored numbers in exact arithmetic. Left of the middle column they overlap, so that a wrong"
                        + " verdict lets something through; right of it they are apart, so that a wrong verdict stops"
                        + " something; in the middle column they touch exactly. This module and JTS mean closed sets: what"
                        + " touches collides. dyn4j means open sets, so that its middle column is another meaning, and"
                        + " keeps a declared tolerance. For JTS and dyn4j corners of turned boxes are rounded to doubles."
                        + " Each point is the share of a decade, over all pairs of the dimension.",
                panels,
                1,
                250));
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            table(results, dimension, page);
        }
    }

    private static List<Subject> subjects(Results results, Dimension dimension) {
        List<Subject> subjects = new ArrayList<>();
        for (Accuracy level : Sizes.backwards()) {
            subjects.add(new Subject(Subject.MODULE, level.name(), dimension.name(), "on"));
        }
        subjects.add(new Subject(Subject.MODULE, Accuracy.EXACT.name(), dimension.name(), "alone"));
        if (dimension == Dimension.PLANAR) {
            subjects.add(Subject.peer(Subject.JTS));
            subjects.add(Subject.peer(Subject.DYN4J));
        }
        List<String> pairs = Resolution.pairs(results, dimension.name());
        subjects.removeIf(subject -> Resolution.bins(results, subject, pairs).isEmpty());
        return subjects;
    }

    private static Panel panel(Results results, Dimension dimension) {
        List<Series> series = new ArrayList<>();
        for (Subject subject : subjects(results, dimension)) {
            List<Dot> dots = new ArrayList<>();
            for (Resolution.Bin bin : Resolution.bins(results, subject, Resolution.pairs(results, dimension.name()))) {
                // In the middle of its decade.
                dots.add(new Dot(bin.gap() * Math.sqrt(10), bin.share(), ""));
            }
            Look look = subject.isModule() && !subject.isAlone()
                    ? Look.of(Accuracy.valueOf(subject.level()))
                    : subject.isAlone() ? new Look(3, Marker.PLUS, false) : Look.of(subject);
            String name = subject.isModule() ? subject.isAlone() ? "filter alone" : subject.level() : subject.engine();
            // JTS and dyn4j have the colours of two levels: their lines are dashed.
            series.add(look.series(name, subject.isModule() ? Line.SOLID : Line.DASHED, dots));
        }
        return new Panel(
                dimension.name(),
                new SignedLogAxis("true gap, world units (below 0: depth)", Verdicts.LOW - 1, Verdicts.HIGH + 1),
                new PercentAxis("wrong"),
                series);
    }

    private static void table(Results results, Dimension dimension, Page page) {
        List<String> pairs = Resolution.pairs(results, dimension.name());
        page.heading(3, "The widest gap at which more than 5 % are wrong, " + dimension);
        List<String> head = new ArrayList<>(List.of("who"));
        head.addAll(pairs);
        head.addAll(List.of("false-collide", "false-free", "exact touch called free", "asked"));
        List<List<String>> rows = new ArrayList<>();
        for (Subject subject : subjects(results, dimension)) {
            List<String> row = new ArrayList<>(List.of(subject.text()));
            for (String pair : pairs) {
                OptionalDouble gap = Resolution.of(results, subject, pair);
                row.add(Words.size(gap));
            }
            List<Resolution.Bin> bins = Resolution.bins(results, subject, pairs);
            row.add(Words.count(Resolution.wrong(bins, 1)));
            row.add(Words.count(Resolution.wrong(bins, -1)));
            row.add(Words.count(Resolution.wrong(bins, 0))
                    + (subject.engine().equals(Subject.DYN4J) ? " (open sets)" : ""));
            row.add(Words.count(Resolution.asked(bins)));
            rows.add(row);
        }
        page.table(head, rows);
    }
}

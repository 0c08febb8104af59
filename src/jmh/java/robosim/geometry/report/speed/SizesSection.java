package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

/** From 100 to 1,000,000 objects. */
final class SizesSection {
    private static final String STUDY = "sizes";

    private SizesSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "From 100 objects to 1,000,000");
        List<Panel> panels = new ArrayList<>();
        for (String query : List.of("ray", "overlap")) {
            panels.add(panel(results, query));
        }
        page.picture(new Figure(
                "sizes",
                "Time of one question as a scene grows at constant density",
                "Generated boxes and upright cylinders, one to each 100 square units; rays of up to 100 units, discs of"
                        + " radius 0.5; one thread, the least of the rounds in which all took turns. This module through"
                        + " `Geometry`, at EXACT; JTS: STRtree with exact words for discs in overlaps and polygons of 32"
                        + " corners for rays; dyn4j: World with its default tree. These two are asked up to 100,000 objects.",
                panels,
                2,
                300));
        for (String query : List.of("ray", "overlap", "cone")) {
            table(results, query, page);
        }
    }

    private static List<String> scenes(Results results) {
        return results.distinct(STUDY, Measure::scene);
    }

    private static Panel panel(Results results, String query) {
        List<Series> series = new ArrayList<>();
        for (Subject subject : List.of(
                Subject.exact(Dimension.PLANAR),
                Subject.exact(Dimension.SPATIAL),
                Subject.peer(Subject.JTS),
                Subject.peer(Subject.DYN4J))) {
            List<Dot> dots = new ArrayList<>();
            for (String scene : scenes(results)) {
                results.value(STUDY, subject, scene, query, Results.NANOS)
                        .ifPresent(nanos -> dots.add(
                                new Dot(Double.parseDouble(scene), nanos, dots.isEmpty() ? "" : Words.time(nanos))));
            }
            String name = subject.isModule() ? "this module, " + subject.dimension() : subject.engine();
            series.add(Look.of(subject).series(name, Line.SOLID, dots));
        }
        double[] nanos = values(series, false);
        return new Panel(
                query.equals("ray") ? "ray, closest hit" : "overlap test",
                LogAxis.around("objects", values(series, true), SizesSection::count),
                LogAxis.roomy("time of one question", nanos, Decades::nanos),
                series);
    }

    private static String count(int exponent) {
        return exponent >= 6 ? "1 million" : Words.count(Math.pow(10, exponent));
    }

    private static double[] values(List<Series> series, boolean isX) {
        return series.stream()
                .flatMap(one -> one.dots().stream())
                .mapToDouble(dot -> isX ? dot.x() : dot.y())
                .toArray();
    }

    private static void table(Results results, String query, Page page) {
        List<Subject> subjects = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            for (Accuracy level : Sizes.backwards()) {
                subjects.add(new Subject(Subject.MODULE, level.name(), dimension.name(), "on"));
            }
        }
        subjects.add(Subject.peer(Subject.JTS));
        subjects.add(Subject.peer(Subject.DYN4J));
        List<String> head = new ArrayList<>(List.of("ns a query"));
        scenes(results).forEach(scene -> head.add(Words.count(Double.parseDouble(scene))));
        List<List<String>> rows = new ArrayList<>();
        for (Subject subject : subjects) {
            List<String> row = new ArrayList<>(List.of(subject.text()));
            for (String scene : scenes(results)) {
                OptionalDouble nanos = results.value(STUDY, subject, scene, query, Results.NANOS);
                row.add(Words.nanos(nanos));
            }
            if (row.stream().skip(1).anyMatch(cell -> !cell.equals(Words.NONE))) {
                rows.add(row);
            }
        }
        page.heading(
                3,
                query.equals("ray") ? "Ray, closest hit" : query.equals("cone") ? "Cone of 15\u00b0" : "Overlap test");
        page.table(head, rows);
    }
}

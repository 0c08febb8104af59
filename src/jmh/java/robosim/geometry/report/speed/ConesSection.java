package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import robosim.geometry.chart.Axis;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Dimension;

/** Cones as they are, and as fans of rays. */
final class ConesSection {
    private static final String STUDY = "cones";

    private ConesSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Cones and fans");
        List<Panel> panels = new ArrayList<>();
        for (String scene : Cones.SCENES) {
            for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
                List<Series> series = series(results, scene + " 15", dimension);
                Axis y = TradeSection.around("99.9 % are off by no more, metres", series);
                panels.add(new Panel(scene + ", " + dimension, TradeSection.nanos(series), y, series));
            }
        }
        page.picture(new Figure(
                "cones",
                "A sonar cone of 15\u00b0: the nearest point of all of it, or the least of a fan of rays",
                "Each point is one way to answer: across, the time of one answer; up, how far 999 of 1,000 answers are"
                        + " longer than the nearest point in the cone, within a range of 20 m (an echo that is not heard"
                        + " counts as 20 m). Fans are level rays over the cone's angle, its edges included. In SPATIAL a"
                        + " level fan also leaves out what is above and below it. The cone itself is exact to 8 units in"
                        + " the last place (a lying cylinder: to 2^-40 of the distance, never late): the strip of 0.",
                panels,
                2,
                230));
        table(results, page);
    }

    /** The exact cone and the fans of a scene. */
    static List<Series> series(Results results, String scene, Dimension dimension) {
        Subject subject = Subject.exact(dimension);
        List<Dot> cone = new ArrayList<>();
        List<Dot> fans = new ArrayList<>();
        results.value(STUDY, subject, scene, "cone", Results.NANOS)
                .ifPresent(nanos -> cone.add(new Dot(nanos, 0, "exact cone")));
        for (int size : Cones.FANS) {
            OptionalDouble nanos = results.value(STUDY, subject, scene, "fan of " + size, Results.NANOS);
            OptionalDouble late = late(results, subject, scene, size);
            if (nanos.isPresent() && late.isPresent()) {
                fans.add(new Dot(nanos.getAsDouble(), late.getAsDouble(), Integer.toString(size)));
            }
        }
        List<Series> series = new ArrayList<>();
        series.add(new Series("exact cone", 0, Marker.CIRCLE, Line.NONE, false, cone));
        series.add(new Series("fan of so many rays", 1, Marker.SQUARE, Line.SOLID, false, fans));
        return series;
    }

    private static OptionalDouble late(Results results, Subject subject, String scene, int size) {
        OptionalDouble late = results.value(STUDY, subject, scene, "fan of " + size, "late q0.999");
        // Few cases do not tell so many nines.
        return late.isPresent() ? late : results.value(STUDY, subject, scene, "fan of " + size, "late q1.0");
    }

    /** What a fan is worth that takes as long as the cone. */
    static void addEqual(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (String scene : Cones.SCENES) {
            for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
                Subject subject = Subject.exact(dimension);
                String name = scene + " 15";
                OptionalDouble cone = results.value(STUDY, subject, name, "cone", Results.NANOS);
                if (cone.isPresent()) {
                    rows.add(equal(results, subject, scene, name, cone.getAsDouble()));
                }
            }
        }
        page.table(
                List.of(
                        "scene",
                        "dimension",
                        "exact cone, ns",
                        "the largest fan that is as fast",
                        "99.9 % are off by up to",
                        "echoes not heard",
                        "1 mm takes"),
                rows);
    }

    private static List<String> equal(Results results, Subject subject, String scene, String name, double cone) {
        int size = Cones.FANS.stream()
                .filter(rays -> results.value(STUDY, subject, name, "fan of " + rays, Results.NANOS)
                                .orElse(Double.POSITIVE_INFINITY)
                        <= cone)
                .reduce(0, Math::max);
        return List.of(
                scene,
                subject.dimension(),
                Words.nanos(cone),
                size == 0 ? "none, not even of 3 rays" : size + " rays",
                size == 0 ? Words.NONE : Words.size(late(results, subject, name, size)) + " m",
                size == 0
                        ? Words.NONE
                        : Words.percent(results.value(STUDY, subject, name, "fan of " + size, "unheard share")
                                .orElse(0)),
                enough(results, subject, name));
    }

    /** The smallest fan of which 99.9 % are within a millimetre. */
    private static String enough(Results results, Subject subject, String name) {
        return Cones.FANS.stream()
                .filter(size -> late(results, subject, name, size).orElse(1) <= 1e-3)
                .findFirst()
                .map(size -> size + " rays")
                .orElse("more than 181 rays");
    }

    private static void table(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (String scene : Cones.SCENES) {
            for (int degrees : Cones.DEGREES) {
                for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
                    row(results, scene, degrees, dimension, rows);
                }
            }
        }
        page.paragraph(
                "Of each fan: its time over that of the exact cone in the same run, and what share of the echoes it"
                        + " does not hear at all. The last column is the smallest fan of which 99.9 % are within 1 mm.");
        List<String> head = new ArrayList<>(List.of("scene", "cone", "dimension", "exact cone, ns"));
        for (int size : List.of(3, 11, 45, 181)) {
            head.add("fan of " + size);
        }
        head.add("1 mm takes");
        page.table(head, rows);
    }

    private static void row(Results results, String scene, int degrees, Dimension dimension, List<List<String>> rows) {
        Subject subject = Subject.exact(dimension);
        String name = scene + " " + degrees;
        OptionalDouble cone = results.value(STUDY, subject, name, "cone", Results.NANOS);
        if (cone.isEmpty()) {
            return;
        }
        List<String> row =
                new ArrayList<>(List.of(scene, degrees + "\u00b0", dimension.name(), Words.nanos(cone.getAsDouble())));
        for (int size : List.of(3, 11, 45, 181)) {
            double nanos = results.value(STUDY, subject, name, "fan of " + size, Results.NANOS)
                    .orElseThrow();
            double unheard = results.value(STUDY, subject, name, "fan of " + size, "unheard share")
                    .orElseThrow();
            row.add(Words.ratio(nanos / cone.getAsDouble()) + ", " + Words.percent(unheard) + " unheard");
        }
        row.add(enough(results, subject, name));
        rows.add(row);
    }
}

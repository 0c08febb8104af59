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
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

/** The main plot: time of a question against what its answer is worth. */
final class TradeSection {
    static final String FIGURE = "speed-against-error";
    static final String TITLE =
            "Speed against error: to the left is faster, further down is truer, on the strip is exact";
    private static final String CONE_SCENE = "rooms 15";

    private TradeSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Speed against error");
        page.picture(figure(results));
    }

    /** The largest generated scene that other engines were asked about, at most 10,000. */
    static String scene(Results results) {
        return results.of("sizes").stream()
                .map(Measure::scene)
                .filter(scene -> Integer.parseInt(scene) <= Worlds.GENERATED)
                .reduce((first, second) -> second)
                .orElse("100");
    }

    static Figure figure(Results results) {
        String caption = "Left: the time of one overlap test (a disc of radius 0.5 in a generated scene of "
                + Words.count(Double.parseDouble(scene(results)))
                + " boxes and cylinders, one thread) against the widest gap between two objects about 1 wide at which more"
                + " than 5 % of the verdicts are wrong, worst of all pairs; strip of 0: none is, down to gaps of 1e-16."
                + " Coarser levels stand for enclosures, which may add collisions and never miss one. JTS and dyn4j work in"
                + " the plane; dyn4j's sets are open and keep a declared tolerance, so exact touch is not counted here."
                + " Hollow: this module with its filters believed and no exact path. Right: a sonar cone of 15\u00b0 in"
                + " worlds/rooms.xml, answered as the nearest point of the whole cone or as the least of a fan of rays over"
                + " the same angle: 99.9 % of the answers are off by no more than shown; the exact cone is within 8 units in"
                + " the last place of the truth.";
        return new Figure(FIGURE, TITLE, caption, List.of(overlaps(results), cones(results)), 2, 400);
    }

    private static Panel overlaps(Results results) {
        List<Series> series = new ArrayList<>();
        String scene = scene(results);
        for (Dimension dimension : List.of(Dimension.PLANAR, Dimension.SPATIAL)) {
            List<Dot> dots = new ArrayList<>();
            for (Accuracy level : Accuracy.values()) {
                Subject subject = new Subject(Subject.MODULE, level.name(), dimension.name(), "on");
                dot(results, subject, scene, level.name(), dots);
            }
            Look look = Look.of(Subject.exact(dimension));
            series.add(look.series("this module, " + dimension, Line.SOLID, dots));
            series.add(alone(results, dimension, scene));
        }
        for (String engine : List.of(Subject.JTS, Subject.DYN4J)) {
            List<Dot> dots = new ArrayList<>();
            dot(results, Subject.peer(engine), scene, engine, dots);
            series.add(Look.of(Subject.peer(engine)).series(engine, Line.NONE, dots));
        }
        return new Panel(
                "Do they touch? " + Words.count(Double.parseDouble(scene)) + " objects",
                nanos(series),
                around("widest misclassified gap, world units", series),
                series);
    }

    private static void dot(Results results, Subject subject, String scene, String label, List<Dot> dots) {
        OptionalDouble nanos = results.value("sizes", subject, scene, "overlap", Results.NANOS);
        OptionalDouble gap = Resolution.worst(results, subject);
        if (nanos.isPresent() && gap.isPresent()) {
            dots.add(new Dot(nanos.getAsDouble(), gap.getAsDouble(), label));
        }
    }

    /** Filters alone: their time over that of the exact verdicts comes from JVMs that took turns. */
    private static Series alone(Results results, Dimension dimension, String scene) {
        Subject exact = Subject.exact(dimension);
        Subject alone = new Subject(Subject.MODULE, Accuracy.EXACT.name(), dimension.name(), "alone");
        List<Dot> dots = new ArrayList<>();
        OptionalDouble nanos = results.value("sizes", exact, scene, "overlap", Results.NANOS);
        OptionalDouble ratio = FilterSection.ratio(results, scene + " generated", dimension, "overlap");
        OptionalDouble gap = Resolution.worst(results, alone);
        if (nanos.isPresent() && ratio.isPresent() && gap.isPresent()) {
            dots.add(new Dot(nanos.getAsDouble() / ratio.getAsDouble(), gap.getAsDouble(), "filter alone"));
        }
        return Look.of(alone).series("filter alone, " + dimension, Line.NONE, dots);
    }

    private static Panel cones(Results results) {
        Subject exact = Subject.exact(Dimension.PLANAR);
        List<Series> series = ConesSection.series(results, CONE_SCENE, Dimension.PLANAR);
        List<Dot> levels = new ArrayList<>();
        for (Accuracy level : Accuracy.values()) {
            Subject subject = new Subject(Subject.MODULE, level.name(), exact.dimension(), "on");
            OptionalDouble nanos = results.value("worlds", subject, "rooms", "cone", Results.NANOS);
            OptionalDouble error = WorldsSection.error(results, subject, "rooms", "cone");
            if (nanos.isPresent() && error.isPresent() && level != Accuracy.EXACT) {
                levels.add(new Dot(nanos.getAsDouble(), error.getAsDouble(), level.name()));
            }
        }
        series.add(new Series("cone at a coarser level", 5, Marker.DIAMOND, Line.NONE, false, levels));
        return new Panel(
                "How far does a sonar hear? rooms.xml, PLANAR",
                nanos(series),
                around("99.9 % are off by no more, metres", series),
                series);
    }

    static Axis nanos(List<Series> series) {
        return LogAxis.roomy("time of one question", values(series, true), Decades::nanos);
    }

    static Axis around(String title, List<Series> series) {
        return LogAxis.roomy(title, values(series, false), Decades::plain);
    }

    private static double[] values(List<Series> series, boolean isX) {
        return series.stream()
                .flatMap(one -> one.dots().stream())
                .mapToDouble(dot -> isX ? dot.x() : dot.y())
                .toArray();
    }
}

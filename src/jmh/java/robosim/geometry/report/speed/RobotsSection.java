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
import robosim.geometry.report.chart.NamesAxis;

/** Steps a second of many robots. */
final class RobotsSection {
    private static final String STUDY = "robots";

    private RobotsSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Robots: steps a second");
        List<Panel> panels = new ArrayList<>();
        for (int robots : Robots.COUNTS) {
            panels.add(panel(results, robots));
        }
        page.picture(new Figure(
                "robots",
                "Steps a second in worlds/warehouse.xml: every robot moves once and hears 16 cone sonars",
                "A warehouse of 84 x 56 m (2,300 parts, 252 rack bays) with so many robots of 0.5 m; each sonar is a whole"
                        + " cone of 15\u00b0 and 20 m that hears shelves and other robots. One thread. In process: calls of"
                        + " `Geometry`. Over TCP: a bundle of moves and a bundle of sonar requests a step, each answered"
                        + " before the next is sent, both ends on this machine. Coarser levels, in process, are told in the"
                        + " table.",
                panels,
                2,
                150));
        table(results, page);
    }

    private static OptionalDouble steps(Results results, Subject subject, String scene, String way) {
        OptionalDouble nanos = results.value(STUDY, subject, scene, way, Results.NANOS);
        return nanos.isPresent() ? OptionalDouble.of(1e9 / nanos.getAsDouble()) : nanos;
    }

    private static Panel panel(Results results, int robots) {
        List<String> names = new ArrayList<>();
        List<Dot> here = new ArrayList<>();
        List<Dot> wire = new ArrayList<>();
        String scene = robots + " robots";
        double most = 1;
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            for (String way : List.of(Robots.IN_PROCESS, Robots.OVER_TCP)) {
                OptionalDouble steps = steps(results, Subject.exact(dimension), scene, way);
                if (steps.isPresent()) {
                    double value = steps.getAsDouble();
                    (way.equals(Robots.IN_PROCESS) ? here : wire)
                            .add(new Dot(value, names.size(), Words.digits(value)));
                    most = Math.max(most, value);
                }
                names.add(dimension + ", " + way);
            }
        }
        return new Panel(
                Words.count(robots) + " robots, " + Words.count(robots * (double) Herd.SONARS) + " cones a step",
                LinearAxis.upTo("steps a second", most * 1.12),
                new NamesAxis("", names),
                List.of(
                        new Series(Robots.IN_PROCESS, 0, Marker.SQUARE, Line.BARS, false, here),
                        new Series(Robots.OVER_TCP, 1, Marker.SQUARE, Line.BARS, false, wire)));
    }

    static void table(Results results, Page page) {
        List<String> head = new ArrayList<>(List.of("level, dimension"));
        for (int robots : Robots.COUNTS) {
            head.add(Words.count(robots) + " robots, in process");
            head.add("over TCP");
            head.add("a cone, in process");
        }
        List<List<String>> rows = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            for (Accuracy level : Sizes.backwards()) {
                Subject subject = WorldsSection.subject(level, dimension);
                List<String> row = new ArrayList<>(List.of(subject.text()));
                for (int robots : Robots.COUNTS) {
                    OptionalDouble here = steps(results, subject, robots + " robots", Robots.IN_PROCESS);
                    OptionalDouble wire = steps(results, subject, robots + " robots", Robots.OVER_TCP);
                    row.add(here.isEmpty() ? Words.NONE : Words.digits(here.getAsDouble()));
                    row.add(wire.isEmpty() ? Words.NONE : Words.digits(wire.getAsDouble()));
                    row.add(here.isEmpty() ? Words.NONE : Words.time(1e9 / here.getAsDouble() / robots / Herd.SONARS));
                }
                rows.add(row);
            }
        }
        page.paragraph(
                "Steps a second, the best of the rounds in which all took turns; a cone's time holds its share of the moves.");
        page.table(head, rows);
    }
}

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
import robosim.geometry.report.chart.NamesAxis;

/** What the levels and dimensions take and give in the worlds of files. */
final class WorldsSection {
    static final String STUDY = "worlds";
    static final List<String> QUERIES = List.of("ray", "cone", "overlap", "move");

    private WorldsSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Levels and dimensions in worlds");
        List<Panel> panels = new ArrayList<>();
        for (String query : QUERIES) {
            panels.add(panel(results, query));
        }
        page.picture(new Figure(
                "worlds",
                "What a level and a dimension take in the worlds of worlds/",
                "Time of one question on one thread: rays of up to 20 m from where a robot may stand; cones of 15\u00b0;"
                        + " robots' bodies tested anywhere; moves of the world's own robots by up to 7 cm. Least of the"
                        + " rounds in which all took turns.",
                panels,
                2,
                330));
        for (String world : results.distinct(STUDY, Measure::scene)) {
            page.heading(3, world + ".xml");
            page.table(head(), rows(results, world));
        }
        page.paragraph(
                "Errors are against EXACT in the same dimension: how much shorter 99.9 % of the distances are at most,"
                        + " and how many tests say yes where EXACT says no; none may say no where EXACT says yes. x is the time over"
                        + " that of EXACT, SPATIAL, the median over the rounds. The last column tells in how many tests of a robot's"
                        + " body the answer is another one than at EXACT, SPATIAL: what it takes to leave heights out.");
    }

    private static Panel panel(Results results, String query) {
        List<String> names = new ArrayList<>();
        List<String> worlds = results.distinct(STUDY, Measure::scene);
        for (String world : worlds) {
            for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
                names.add(world + ", " + dimension);
            }
        }
        List<Series> series = new ArrayList<>();
        for (Accuracy level : Sizes.backwards()) {
            List<Dot> dots = new ArrayList<>();
            int line = 0;
            for (String world : worlds) {
                for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
                    int at = line++;
                    results.value(STUDY, subject(level, dimension), world, query, Results.NANOS)
                            .ifPresent(nanos -> dots.add(new Dot(nanos, at, "")));
                }
            }
            series.add(Look.of(level).series(level.name(), Line.NONE, dots));
        }
        double[] all = series.stream()
                .flatMap(one -> one.dots().stream())
                .mapToDouble(Dot::x)
                .toArray();
        return new Panel(
                query.equals("cone") ? "cone of 15\u00b0" : query,
                LogAxis.roomy("time of one question", all, Decades::nanos),
                new NamesAxis("", names),
                series);
    }

    static Subject subject(Accuracy level, Dimension dimension) {
        return new Subject(Subject.MODULE, level.name(), dimension.name(), "on");
    }

    private static List<String> head() {
        return List.of(
                "level, dimension",
                "ray, ns",
                "x",
                "short by, m: 90 %, 99.9 %",
                "cone, ns",
                "x",
                "short by, m: 90 %, 99.9 %",
                "overlap, ns",
                "x",
                "collisions added",
                "move, ns",
                "x",
                "tests unlike EXACT, SPATIAL");
    }

    private static List<List<String>> rows(Results results, String world) {
        List<List<String>> rows = new ArrayList<>();
        for (Dimension dimension : List.of(Dimension.SPATIAL, Dimension.PLANAR)) {
            for (Accuracy level : Sizes.backwards()) {
                Subject subject = subject(level, dimension);
                List<String> row = new ArrayList<>(List.of(subject.text()));
                for (String query : QUERIES) {
                    row.add(Words.nanos(results.value(STUDY, subject, world, query, Results.NANOS)));
                    row.add(Words.ratio(ratio(results, subject, world, query)));
                    if (query.equals("overlap")) {
                        row.add(share(results, subject, world, "added share"));
                    } else if (!query.equals("move")) {
                        row.add(Words.size(results.value(STUDY, subject, world, query, "error q0.9")) + ", "
                                + Words.size(error(results, subject, world, query)));
                    }
                }
                double unlike = results.value(STUDY, subject, world, "overlap", "of SPATIAL added share")
                                .orElse(0)
                        + results.value(STUDY, subject, world, "overlap", "of SPATIAL missed share")
                                .orElse(0);
                row.add(Words.percent(unlike));
                rows.add(row);
            }
        }
        return rows;
    }

    /** The least time over that of EXACT, SPATIAL: what else runs on a machine spoils a least time least. */
    private static OptionalDouble ratio(Results results, Subject subject, String world, String query) {
        OptionalDouble own = results.value(STUDY, subject, world, query, Results.NANOS);
        OptionalDouble exact = results.value(STUDY, Subject.exact(Dimension.SPATIAL), world, query, Results.NANOS);
        return own.isPresent() && exact.isPresent()
                ? OptionalDouble.of(own.getAsDouble() / exact.getAsDouble())
                : OptionalDouble.empty();
    }

    /** What 99.9 % are off by at most; of few cases the most. */
    static OptionalDouble error(Results results, Subject subject, String world, String query) {
        OptionalDouble error = results.value(STUDY, subject, world, query, "error q0.999");
        return error.isPresent() ? error : results.value(STUDY, subject, world, query, "error q1.0");
    }

    private static String share(Results results, Subject subject, String world, String metric) {
        OptionalDouble share = results.value(STUDY, subject, world, "overlap", metric);
        return share.isEmpty() ? Words.NONE : Words.percent(share.getAsDouble());
    }
}

package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

/** Native engines on shared inputs, where a file of their figures was given. */
final class PeersSection {
    private static final Map<String, String> WORKS = Map.of(
            "W1a", "ray among flat objects",
            "W1b", "disc tested among them",
            "W1c", "checked addition",
            "W2", "pair of meshes",
            "W3", "ray at a mesh",
            "W4", "attempted move in a swarm",
            "W5", "ray among solids in space",
            "W6", "rays of camera frames among them");

    private static final List<String> DRAWN = List.of("W1a", "W1b", "W5", "W6");

    /** A question of each kind of scene. */
    private static final List<String> BUILT = List.of("W1a", "W5");

    /** An attempt that was measured and left out. */
    private static final String NOT_FASTER =
            "What did not help: the four children of a node in the tree of objects sorted without branches, as the trees"
                    + " of meshes do it. Single rays took 1.1 to 1.2 times as long among 50 and 1,000 meshes, in one run"
                    + " on a busy machine, so branches stay there.";

    private PeersSection() {}

    static void add(Results results, Page page) {
        if (results.of(PeerLines.STUDY).isEmpty()) {
            return;
        }
        page.heading(2, "Native engines");
        List<Panel> panels = new ArrayList<>();
        for (String work : DRAWN) {
            if (results.distinct(PeerLines.STUDY, Measure::query).contains(work)) {
                panels.add(panel(results, work));
            }
        }
        if (!panels.isEmpty()) {
            page.picture(new Figure(
                    "peers",
                    "This module beside native engines on the same inputs, one run of bench.Peers",
                    "Flat boxes and discs, and boxes, cylinders and spheres at any attitude in space, at constant density;"
                            + " one thread. A ray is answered with its closest hit, a disc with whether it touches anything."
                            + " Medians over several JVMs, the engines in turn with"
                            + " them. What each found, and how far the JVMs differ, is in the table.",
                    panels,
                    2,
                    300));
        }
        table(results, page);
        structures(results, page);
        page.paragraph(NOT_FASTER);
    }

    /** Those of the pictures, so that each has a colour and a marker of its own, the same in all of them. */
    private static List<Subject> subjects(Results results) {
        return results.of(PeerLines.STUDY).stream()
                .filter(measure -> DRAWN.contains(measure.query()))
                .map(Measure::subject)
                .distinct()
                .toList();
    }

    private static Panel panel(Results results, String work) {
        List<Series> series = new ArrayList<>();
        int colour = 0;
        for (Subject subject : subjects(results)) {
            List<Dot> dots = new ArrayList<>();
            for (Measure measure : results.of(PeerLines.STUDY)) {
                boolean isNumber = measure.scene().matches("[0-9]+");
                if (isNumber
                        && measure.subject().equals(subject)
                        && measure.query().equals(work)
                        && measure.metric().equals(Results.NANOS)) {
                    dots.add(new Dot(
                            Double.parseDouble(measure.scene()),
                            measure.value(),
                            subject.isModule() ? Words.time(measure.value()) : ""));
                }
            }
            int at = colour++;
            Marker marker = Marker.values()[at % Marker.values().length];
            if (!dots.isEmpty()) {
                series.add(new Series(subject.engine(), at % 8, marker, Line.SOLID, false, dots));
            }
        }
        double[] sizes = series.stream()
                .flatMap(one -> one.dots().stream())
                .mapToDouble(Dot::x)
                .toArray();
        double[] nanos = series.stream()
                .flatMap(one -> one.dots().stream())
                .mapToDouble(Dot::y)
                .toArray();
        return new Panel(
                WORKS.get(work),
                LogAxis.around("objects", sizes, Decades::plain),
                LogAxis.roomy("time of one question", nanos, Decades::nanos),
                series);
    }

    private static void table(Results results, Page page) {
        Subject own = new Subject(Subject.MODULE, "", "", "");
        List<List<String>> rows = new ArrayList<>();
        for (Measure measure : results.of(PeerLines.STUDY)) {
            if (measure.metric().equals(Results.NANOS)) {
                OptionalDouble ours =
                        results.value(PeerLines.STUDY, own, measure.scene(), measure.query(), Results.NANOS);
                String what = WORKS.getOrDefault(measure.query(), "");
                rows.add(List.of(
                        measure.query() + (what.isEmpty() ? "" : ": " + what),
                        measure.scene(),
                        measure.subject().engine(),
                        Words.nanos(measure.value()),
                        results
                                .value(PeerLines.STUDY, measure.subject(), measure.scene(), measure.query(), "hits")
                                .stream()
                                .mapToObj(Words::count)
                                .findFirst()
                                .orElse(Words.NONE),
                        spread(results, measure),
                        other(results, measure, "beside"),
                        ours.isEmpty() || measure.subject().isModule()
                                ? Words.NONE
                                : Words.ratio(ours.getAsDouble() / measure.value())));
            }
        }
        page.table(
                List.of(
                        "workload",
                        "size",
                        "who",
                        "ns a query",
                        "hits",
                        "least to most",
                        "beside a neighbour",
                        "this module takes"),
                rows);
        page.paragraph(
                "Medians over the JVMs of a run, then the least and the most of them. The neighbour is a thread that sweeps"
                        + " through memory larger than any cache.");
    }

    /** What the scenes cost before the first question, by size, where the file tells the memory too. */
    private static void structures(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (Measure measure : results.of(PeerLines.STUDY)) {
            if (measure.metric().equals(PeerLines.BYTES) && BUILT.contains(measure.query())) {
                rows.add(List.of(
                        WORKS.get(measure.query()),
                        Words.count(Double.parseDouble(measure.scene())),
                        measure.subject().engine(),
                        other(results, measure, PeerLines.BUILD),
                        Words.count(measure.value())));
            }
        }
        if (!rows.isEmpty()) {
            page.paragraph("Building and memory: objects are added and one question is asked.");
            page.table(List.of("scene", "objects", "who", "ms", "bytes an object"), rows);
            page.paragraph(
                    "This module's bytes are all that a world needs beside the objects themselves, which the caller"
                            + " has; an engine's are what it reports, without the scene that its callback reads.");
        }
    }

    private static String spread(Results results, Measure measure) {
        String least = other(results, measure, "least");
        return least.equals(Words.NONE) ? least : least + " to " + other(results, measure, "most");
    }

    /** Another figure of the same row, where the file had it. */
    private static String other(Results results, Measure measure, String metric) {
        OptionalDouble value =
                results.value(PeerLines.STUDY, measure.subject(), measure.scene(), measure.query(), metric);
        return value.isEmpty() ? Words.NONE : Words.nanos(value.getAsDouble());
    }
}

package robosim.geometry.report.speed;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.model.Dimension;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;
import robosim.geometry.report.chart.NamesAxis;

/** Sensors, pictures, the window and the page, beside what they are to reach. */
final class SensorsSection {
    private static final String STUDY = "sensors";
    private static final Subject MODULE = Subject.exact(Dimension.SPATIAL);

    /** What is to be reached by a frame, in nanoseconds; infinite where nothing was set. */
    private record Target(String query, double must, double aim) {}

    private static final List<Target> FRAMES = List.of(
            new Target(Sensors.DEPTH, 20e6, 10e6),
            new Target(Sensors.LIDAR, 15e6, 8e6),
            new Target(Sensors.NOISY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY),
            new Target(Sensors.COLOUR, 60e6, 30e6),
            new Target(Sensors.COLOUR_SKY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY));

    private static final Target NOISE = new Target("", 25, 10);

    private SensorsSection() {}

    static void add(Results results, Page page) {
        page.heading(2, "Sensors and pictures");
        page.picture(new Figure(
                "sensors",
                "A frame of a sensor, and the noise of a ray",
                "Worlds of the folder worlds with a floor and textures, six free places each; one thread. Depth and lidar look"
                        + " 100 m far; pictures in colour have the sun and its shadows, and one has the sky's, 3 rays for each pixel. Noise is"
                        + " measured alone, without the normals and the cones that two of the effects need.",
                List.of(frames(results), noise(results)),
                2,
                430));
        table(results, page);
        page(results, page);
        peers(results, page);
    }

    private static Panel frames(Results results) {
        List<String> names = new ArrayList<>();
        List<Dot> own = new ArrayList<>();
        List<Dot> must = new ArrayList<>();
        List<Dot> aim = new ArrayList<>();
        for (Target target : FRAMES) {
            for (String scene : SensorScene.NAMES) {
                OptionalDouble nanos = results.value(STUDY, MODULE, scene, target.query, Results.NANOS);
                if (nanos.isPresent()) {
                    place(target, names.size(), nanos.getAsDouble(), own, must, aim);
                    names.add(target.query
                                    .replace(" 320 x 240", "")
                                    .replace(" 16 x 1800", "")
                                    .replace(" with the sky's shadows", " and sky")
                            + ", "
                            + scene);
                }
            }
        }
        return panel("a frame", "time of a frame", names, own, must, aim);
    }

    private static Panel noise(Results results) {
        List<String> names = new ArrayList<>();
        List<Dot> own = new ArrayList<>();
        List<Dot> must = new ArrayList<>();
        List<Dot> aim = new ArrayList<>();
        for (String kind : SensorNoise.kinds().keySet()) {
            OptionalDouble nanos = results.value(STUDY, MODULE, SensorNoise.SCENE, kind, Results.NANOS);
            if (nanos.isPresent()) {
                place(NOISE, names.size(), nanos.getAsDouble(), own, must, aim);
                names.add(
                        kind.equals(SensorNoise.TYPICAL)
                                ? "three of them"
                                : kind.equals(SensorNoise.ALL) ? "five of them" : kind);
            }
        }
        return panel("noise", "time of a ray", names, own, must, aim);
    }

    private static void place(Target target, int at, double nanos, List<Dot> own, List<Dot> must, List<Dot> aim) {
        own.add(new Dot(nanos, at, Words.time(nanos)));
        if (target.must < Double.POSITIVE_INFINITY) {
            must.add(new Dot(target.must, at, ""));
            aim.add(new Dot(target.aim, at, ""));
        }
    }

    private static Panel panel(
            String title, String axis, List<String> names, List<Dot> own, List<Dot> must, List<Dot> aim) {
        double[] all = Stream.of(own, must, aim)
                .flatMap(List::stream)
                .mapToDouble(Dot::x)
                .toArray();
        return new Panel(
                title,
                LogAxis.roomy(axis, all, Decades::nanos),
                new NamesAxis("", names),
                List.of(
                        new Series("measured", 0, Marker.CIRCLE, Line.NONE, false, own),
                        new Series("must be reached", 4, Marker.CROSS, Line.NONE, false, must),
                        new Series("is aimed at", 1, Marker.SQUARE, Line.NONE, false, aim)));
    }

    private static void table(Results results, Page page) {
        List<List<String>> rows = new ArrayList<>();
        for (Target target : FRAMES) {
            for (String scene : SensorScene.NAMES) {
                OptionalDouble nanos = results.value(STUDY, MODULE, scene, target.query, Results.NANOS);
                if (nanos.isPresent()) {
                    rows.add(List.of(
                            target.query,
                            scene,
                            Words.time(nanos.getAsDouble()),
                            overBare(results, scene, target.query),
                            target.must < Double.POSITIVE_INFINITY ? Words.time(target.must) : Words.NONE,
                            target.aim < Double.POSITIVE_INFINITY ? Words.time(target.aim) : Words.NONE));
                }
            }
        }
        for (String kind : SensorNoise.kinds().keySet()) {
            results.value(STUDY, MODULE, SensorNoise.SCENE, kind, Results.NANOS)
                    .ifPresent(nanos -> rows.add(List.of(
                            "noise, a ray: " + kind,
                            Words.NONE,
                            Words.time(nanos),
                            Words.NONE,
                            Words.time(NOISE.must),
                            Words.time(NOISE.aim))));
        }
        page.table(List.of("what", "scene", "measured", "over the bare frame", "must", "aim"), rows);
        page.paragraph(
                "Over the bare frame: over `Geometry.sense` of the same rays without a sensor, least time over least"
                        + " time; 1.1 at most must be reached for depth, 1.02 is aimed at.");
    }

    private static String overBare(Results results, String scene, String query) {
        OptionalDouble own = results.value(STUDY, MODULE, scene, query, Results.NANOS);
        OptionalDouble bare = results.value(
                STUDY,
                Subject.peer(Sensors.BARE),
                scene,
                query.equals(Sensors.NOISY) ? Sensors.LIDAR : query,
                Results.NANOS);
        return own.isEmpty() || bare.isEmpty() ? Words.NONE : Words.ratio(own.getAsDouble() / bare.getAsDouble());
    }

    private static void page(Results results, Page page) {
        results.value(STUDY, Subject.exact(Dimension.PLANAR), "1000 objects", Sensors.PAGE, Sensors.BYTES)
                .ifPresent(bytes -> page.paragraph("A page of 1,000 objects, 20 of which move, and 3,000 steps has "
                        + Words.count(bytes) + " bytes; 5 MB must be reached, 2 MB are aimed at."));
    }

    private static void peers(Results results, Page page) {
        Subject embree = Subject.peer(SensorPeers.EMBREE);
        List<List<String>> rows = new ArrayList<>();
        for (String scene : SensorScene.NAMES) {
            String name = SensorPeers.boxes(scene);
            for (String query : List.of(Sensors.DEPTH, Sensors.LIDAR)) {
                for (Subject subject : List.of(MODULE, Subject.peer(SensorPeers.RAY_BY_RAY), embree)) {
                    OptionalDouble nanos = results.value(STUDY, subject, name, query, Results.NANOS);
                    if (nanos.isPresent()) {
                        rows.add(List.of(
                                query,
                                name,
                                subject.equals(MODULE) ? "this module, a frame" : subject.engine(),
                                Words.time(nanos.getAsDouble()),
                                wrong(results, subject, name, query),
                                Words.size(results.value(STUDY, subject, name, query, SensorPeers.WORST))));
                    }
                }
            }
        }
        if (!rows.isEmpty()) {
            page.paragraph(
                    "Embree 3.13 beside it, with the same boxes, upright cylinders and spheres as shapes of its user, whose"
                            + " kernels compute in doubles, and the same rays one by one in its coherent mode (depth) or not (lidar); meshes"
                            + " are left out for both. Wrong: off by more than 1e-7 m from exact arithmetic, of the rays that were judged."
                            + " The last column is the largest difference, in metres, to this module over all rays.");
            page.table(List.of("frame", "scene", "who", "time", "wrong", "largest difference"), rows);
        }
    }

    private static String wrong(Results results, Subject subject, String scene, String query) {
        OptionalDouble judged = results.value(STUDY, subject, scene, query, SensorPeers.JUDGED);
        OptionalDouble wrong = results.value(STUDY, subject, scene, query, SensorPeers.WRONG);
        return judged.isEmpty() || wrong.isEmpty()
                ? "the same bits as a frame"
                : Words.count(wrong.getAsDouble()) + " of " + Words.count(judged.getAsDouble());
    }
}

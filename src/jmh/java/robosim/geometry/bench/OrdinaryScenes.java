package robosim.geometry.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntSupplier;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.exact.Stages;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.BoxObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.WorldReader;

/** The work that {@link Exactness} measures, in a JVM of its own: what a simulator asks in ordinary worlds. */
final class OrdinaryScenes {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double RANGE = 20;

    /** Questions of one kind; the task asks some and answers how many. */
    private record Work(String name, IntSupplier task) {}

    private OrdinaryScenes() {}

    /**
     * For each scene a line: its name, nanoseconds of processor time a question, questions, and falls to exact paths.
     *
     * @param args milliseconds to warm up and to measure each
     */
    public static void main(String[] args) {
        for (Work work : scenes()) {
            rounds(work, Double.parseDouble(args[0]) * 1e6);
            long before = falls();
            Rounds measured = rounds(work, Double.parseDouble(args[1]) * 1e6);
            double[] nanos = measured.nanos().stream().mapToDouble(n -> n).toArray();
            Timing.print("%s;%.3f;%d;%d", work.name(), Timing.median(nanos), measured.questions(), falls() - before);
        }
    }

    /** Nanoseconds a question of each round, and questions of all. */
    private record Rounds(List<Double> nanos, long questions) {}

    private static Rounds rounds(Work work, double least) {
        List<Double> nanos = new ArrayList<>();
        long questions = 0;
        double sum = 0;
        while (sum < least || nanos.size() < 5) {
            long start = THREADS.getCurrentThreadCpuTime();
            int asked = work.task().getAsInt();
            double time = THREADS.getCurrentThreadCpuTime() - start;
            nanos.add(time / asked);
            questions += asked;
            sum += time;
        }
        return new Rounds(nanos, questions);
    }

    private static long falls() {
        return Stages.counts().values().stream().mapToLong(Long::longValue).sum();
    }

    private static List<Work> scenes() {
        List<Work> scenes = new ArrayList<>();
        for (String world : new String[] {"warehouse", "rooms", "maze", "cylinders", "meshes"}) {
            Geometry geometry = read(world);
            List<String> robots = geometry.objects().stream()
                    .filter(GeometryObject::isMoveable)
                    .map(GeometryObject::name)
                    .toList();
            scenes.add(new Work(world + ": sonar rays", () -> sonars(geometry, robots, 0)));
            scenes.add(new Work(world + ": sonar cones", () -> sonars(geometry, robots, 15)));
            SplittableRandom random = new SplittableRandom(4);
            scenes.add(new Work(world + ": moves and turns", () -> moves(geometry, robots, random)));
        }
        Scene scene = new Scene(1000, 1);
        List<GeometryObject> objects = scene.objects(1000);
        for (Dimension dimension : Dimension.values()) {
            scenes.add(new Work("additions, " + dimension, () -> additions(objects, scene.side() + 20, dimension)));
        }
        List<GeometryObject> boxes = boxes();
        scenes.add(new Work("pairs of turned boxes", () -> pairs(boxes)));
        return scenes;
    }

    private static Geometry read(String name) {
        try {
            return WorldReader.read(Path.of("worlds", name + ".xml")).toGeometry();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    // Robots go ahead, turn where they are refused, and back where there is no room for that either.
    private static int moves(Geometry geometry, List<String> robots, SplittableRandom random) {
        int asked = 0;
        for (int step = 0; step < 50; step++) {
            for (String robot : robots) {
                double way = random.nextDouble(0.04, 0.06);
                asked++;
                if (!geometry.simpleMove(robot, way, 0, 0)) {
                    asked++;
                    if (!geometry.simpleTurn(robot, random.nextDouble(-90, 90))) {
                        asked++;
                        geometry.simpleMove(robot, -way, 0, 0);
                    }
                }
            }
        }
        return asked;
    }

    private static int sonars(Geometry geometry, List<String> robots, double width) {
        int asked = 0;
        double sum = 0;
        for (String robot : robots) {
            for (int k = 0; k < 16; k++) {
                double angle = k * Math.PI / 8 + 0.1;
                sum += geometry.getSonarDistance(robot, StrictMath.cos(angle), StrictMath.sin(angle), 0, RANGE, width);
                asked++;
            }
        }
        return sum == -1 ? 0 : asked;
    }

    private static int additions(List<GeometryObject> objects, double world, Dimension dimension) {
        Geometry geometry = new Geometry(world, 10, world, dimension, Accuracy.EXACT);
        objects.forEach(geometry::addObject);
        return objects.size();
    }

    private static List<GeometryObject> boxes() {
        SplittableRandom random = new SplittableRandom(6);
        List<GeometryObject> boxes = new ArrayList<>();
        for (int k = 0; k < 100; k++) {
            Point center = new Point(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2));
            boxes.add(new BoxObject(center, random.nextDouble(2), random.nextDouble(2), random.nextDouble(2))
                    .turned(random.nextDouble(-180, 180), random.nextDouble(-180, 180)));
        }
        return boxes;
    }

    private static int pairs(List<GeometryObject> boxes) {
        int hits = 0;
        int asked = 0;
        for (GeometryObject a : boxes) {
            for (GeometryObject b : boxes) {
                hits += CollisionDetection.intersects(a, b) ? 1 : 0;
                asked++;
            }
        }
        return hits < 0 ? 0 : asked;
    }
}

package robosim.geometry.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;
import java.util.function.IntUnaryOperator;
import java.util.function.LongSupplier;
import robosim.geometry.Geometry;
import robosim.geometry.collision.CollisionDetection;
import robosim.geometry.exact.StageCounters;
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

    private static final List<String> WORLDS = List.of("warehouse", "rooms", "maze", "cylinders", "meshes");

    /** Questions of one kind, in parts: a part is prepared, which is not measured, and asked, and tells how many it was. */
    private record Work(String name, int parts, IntConsumer prepare, IntUnaryOperator ask, LongSupplier strayed) {
        Work(String name, IntSupplier task) {
            this(name, 1, part -> {}, part -> task.getAsInt(), () -> 0);
        }
    }

    private OrdinaryScenes() {}

    /**
     * For each scene a line: its name, nanoseconds of processor time a question, questions, falls to pairs of doubles, falls
     * to exact paths, and legs of trips that began elsewhere than recorded.
     *
     * @param args milliseconds to warm up and to measure each; the file of the {@link #record recorded} trips
     */
    public static void main(String[] args) throws IOException {
        for (Work work : scenes(Files.readAllLines(Path.of(args[2])))) {
            rounds(work, Double.parseDouble(args[0]) * 1e6);
            long fine = falls(true);
            long exact = falls(false);
            Rounds measured = rounds(work, Double.parseDouble(args[1]) * 1e6);
            double[] nanos = measured.nanos().stream().mapToDouble(n -> n).toArray();
            Timing.print(
                    "%s;%.3f;%d;%d;%d;%d",
                    work.name(),
                    Timing.median(nanos),
                    measured.questions(),
                    falls(true) - fine,
                    falls(false) - exact,
                    work.strayed().getAsLong());
        }
    }

    /** Nanoseconds a question of each round, and questions of all. */
    private record Rounds(List<Double> nanos, long questions) {}

    private static Rounds rounds(Work work, double least) {
        List<Double> nanos = new ArrayList<>();
        long questions = 0;
        double sum = 0;
        while (sum < least || nanos.size() < 5) {
            double time = 0;
            int asked = 0;
            for (int part = 0; part < work.parts(); part++) {
                work.prepare().accept(part);
                long start = THREADS.getCurrentThreadCpuTime();
                asked += work.ask().applyAsInt(part);
                time += THREADS.getCurrentThreadCpuTime() - start;
            }
            nanos.add(time / asked);
            questions += asked;
            sum += time;
        }
        return new Rounds(nanos, questions);
    }

    private static long falls(boolean fine) {
        return StageCounters.counts().entrySet().stream()
                .filter(stage -> stage.getKey().endsWith(" fine") == fine)
                .mapToLong(Map.Entry::getValue)
                .sum();
    }

    /** Writes the robots' trips in all worlds to a file, as this JVM answers: a line for each question. */
    static void record(Path file) throws IOException {
        List<String> lines = new ArrayList<>();
        for (String world : WORLDS) {
            Trip.record(read(world)).forEach(question -> lines.add(world + ":" + question));
        }
        Files.write(file, lines);
    }

    private static Trip trip(String world, List<String> lines) {
        String begin = world + ":";
        return Trip.of(
                read(world),
                lines.stream()
                        .filter(line -> line.startsWith(begin))
                        .map(line -> line.substring(begin.length()))
                        .toList());
    }

    private static List<Work> scenes(List<String> trips) {
        List<Work> scenes = new ArrayList<>();
        for (String world : WORLDS) {
            Geometry geometry = read(world);
            List<String> robots = geometry.objects().stream()
                    .filter(GeometryObject::isMoveable)
                    .map(GeometryObject::name)
                    .toList();
            scenes.add(new Work(world + ": sonar rays", () -> sonars(geometry, robots, 0)));
            scenes.add(new Work(world + ": sonar cones", () -> sonars(geometry, robots, 15)));
            Trip trip = trip(world, trips);
            scenes.add(new Work(world + ": moves and turns", trip.legs(), trip::prepare, trip::ask, trip::strayed));
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

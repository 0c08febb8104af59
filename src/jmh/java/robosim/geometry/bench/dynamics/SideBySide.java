package robosim.geometry.bench.dynamics;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import robosim.geometry.chart.Figure;
import robosim.geometry.chart.Marker;
import robosim.geometry.chart.Panel;
import robosim.geometry.chart.Series;
import robosim.geometry.chart.Series.Dot;
import robosim.geometry.chart.Series.Line;
import robosim.geometry.dynamics.proof.FlatShape;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.report.chart.Decades;
import robosim.geometry.report.chart.LogAxis;

/**
 * The same planar scenes here and by dyn4j at its defaults, in turns in one JVM, at several lengths of a step: steps a second,
 * deepest overlap after any step, bodies that left the cell in which they began, and what became of the energy.
 * {@code -Dseconds=4 -Drounds=3}; {@code -Dpublish} writes {@code docs/report/steps.md} and its plot.
 */
public final class SideBySide {
    private static final Path REPORT = Path.of("docs", "report");

    /** Seconds a step. */
    private static final double[] STEPS = {0.001, 0.005, 0.02, 0.1};

    /** What came of a run. */
    private record Run(double nanos, double deepest, int tunnelled, int stopped, double grown, double drift) {}

    /** What came of all rounds: the median time of a step, and the rest, which is the same in each. */
    private record Row(SideScene scene, double step, boolean isOwn, double nanos, Run run) {}

    private SideBySide() {}

    /** Runs all and prints a line for each. */
    public static void main(String[] args) throws IOException {
        double seconds = Double.parseDouble(System.getProperty("seconds", "4"));
        int rounds = Integer.getInteger("rounds", 3);
        List<Row> rows = new ArrayList<>();
        for (SideScene scene : List.of(SideScene.crowd(), SideScene.cells(), SideScene.billiards())) {
            for (double step : STEPS) {
                double[][] nanos = new double[2][rounds];
                Run[] last = new Run[2];
                for (int round = 0; round < rounds; round++) {
                    for (int who = 0; who < 2; who++) {
                        Function<SideScene, SideEngine> maker = who == 0 ? SideEngine.Own::new : SideEngine.Dyn4j::new;
                        last[who] = run(scene, maker.apply(scene), step, seconds);
                        nanos[who][round] = last[who].nanos;
                    }
                }
                for (int who = 0; who < 2; who++) {
                    Arrays.sort(nanos[who]);
                    Row row = new Row(scene, step, who == 0, nanos[who][rounds / 2], last[who]);
                    rows.add(row);
                    System.out.println(line(row));
                }
            }
        }
        if (System.getProperty("publish") != null) {
            publish(rows, seconds, rounds);
        }
    }

    private static Run run(SideScene scene, SideEngine engine, double step, double seconds) {
        List<FlatShape> walls = scene.walls.stream().map(FlatShape::of).toList();
        int[] cells = scene.bodies.stream().mapToInt(body -> cell(scene, body)).toArray();
        boolean[] hasLeft = new boolean[cells.length];
        double deepest = 0;
        double grown = 0;
        long nanos = 0;
        int stopped = 0;
        int count = (int) Math.round(seconds / step);
        int stirred = (int) Math.round(SideScene.STIRRED / step);
        double first = Double.NaN;
        double energy = 0;
        for (int k = 0; k < count; k++) {
            if (k == 0 || (scene.isStirred && k % stirred == 0)) {
                engine.stir(scene.velocities(k / stirred));
                energy = engine.energy();
                first = k == 0 ? energy : first;
            }
            long start = System.nanoTime();
            engine.step(step);
            nanos += System.nanoTime() - start;
            stopped += engine.stopped();
            double now = engine.energy();
            grown = Math.max(grown, now / energy - 1);
            energy = now;
            deepest = Math.max(deepest, look(scene, engine.bodies(), walls, cells, hasLeft));
        }
        int tunnelled = 0;
        for (boolean left : hasLeft) {
            tunnelled += left ? 1 : 0;
        }
        // A rounding is not growth.
        return new Run(
                (double) nanos / count, deepest, tunnelled, stopped, grown < 1e-12 ? 0 : grown, energy / first - 1);
    }

    private static int cell(SideScene scene, GeometryObject body) {
        Point c = body.center();
        return scene.cellOf(c.x(), c.z());
    }

    /** The deepest overlap, exactly 0 if there is none; notes who is in another cell than at the beginning. */
    private static double look(
            SideScene scene, List<GeometryObject> bodies, List<FlatShape> walls, int[] cells, boolean[] hasLeft) {
        FlatShape[] shapes = new FlatShape[bodies.size()];
        double deepest = 0;
        for (int i = 0; i < shapes.length; i++) {
            shapes[i] = FlatShape.of(bodies.get(i));
            hasLeft[i] |= cell(scene, bodies.get(i)) != cells[i];
            for (FlatShape wall : walls) {
                deepest = Math.max(deepest, depth(shapes[i], wall));
            }
            for (int j = 0; j < i; j++) {
                deepest = Math.max(deepest, depth(shapes[i], shapes[j]));
            }
        }
        return deepest;
    }

    private static double depth(FlatShape a, FlatShape b) {
        double depth = FlatShape.depth(a, b);
        // Within a rounding of touching the exact question decides.
        return depth > -1e-12 && FlatShape.overlap(a, b) ? Math.max(depth, Double.MIN_VALUE) : 0;
    }

    private static String line(Row row) {
        return String.format(
                Locale.ROOT,
                "| %s | %s ms | %s | %,.0f | %s | %d | %s | %s | %s |",
                row.scene.name,
                milliseconds(row.step),
                row.isOwn ? "this module" : "dyn4j",
                1e9 / row.nanos,
                row.run.deepest == 0 ? "0" : String.format(Locale.ROOT, "%.1e", row.run.deepest),
                row.run.tunnelled,
                row.isOwn ? String.format(Locale.ROOT, "%,d", row.run.stopped) : "",
                row.run.grown == 0 ? "0" : String.format(Locale.ROOT, "%.1e", row.run.grown),
                row.scene.isStirred ? "" : String.format(Locale.ROOT, "%.1e", row.run.drift));
    }

    private static String milliseconds(double step) {
        return String.format(Locale.ROOT, "%.0f", step * 1e3);
    }

    private static void publish(List<Row> rows, double seconds, int rounds) throws IOException {
        List<Panel> panels = new ArrayList<>();
        double[] deepest = rows.stream().mapToDouble(row -> row.run.deepest).toArray();
        double[] speeds = rows.stream().mapToDouble(SideBySide::speed).toArray();
        for (SideScene scene : rows.stream().map(Row::scene).distinct().toList()) {
            panels.add(new Panel(
                    scene.name,
                    LogAxis.roomy("deepest overlap after a step, metres", deepest, Decades::plain),
                    LogAxis.roomy("simulated seconds a second", speeds, Decades::plain),
                    List.of(series(rows, scene, true), series(rows, scene, false))));
        }
        Figure figure = new Figure(
                "steps",
                "Speed against overlap of steps, beside dyn4j",
                "Each point is a length of a step, in milliseconds; further up is faster, further left is less overlap, and the"
                        + " strip on the left is none at all. dyn4j 6.0.0 at its defaults, the same bodies, walls, surfaces and"
                        + " velocities; both took turns in one JVM on one core.",
                panels,
                3,
                300);
        Files.writeString(REPORT.resolve("steps.svg"), figure.svg());
        StringBuilder page = new StringBuilder("# Steps beside dyn4j\n\n");
        page.append(String.format(Locale.ROOT, """
                The same planar scenes, here and by dyn4j 6.0.0 at its defaults, each for %.0f simulated seconds at several \
                lengths of a step: medians of %d rounds in turns in one JVM, on one core. Only ratios within a run carry over \
                to another machine.

                """, seconds, rounds));
        rows.stream()
                .map(Row::scene)
                .distinct()
                .forEach(scene -> page.append("- *")
                        .append(scene.name)
                        .append("*: ")
                        .append(scene.text)
                        .append(".\n"));
        page.append("""

                An overlap is looked for after every step, by code that neither engine shares; where it is within a rounding \
                of touching, the exact question decides. A body is tunnelled if it has been in another cell than that in which \
                it began, or outside.

                Stopped are bodies that this module could not carry where they were to go, each time that it happened: they \
                lose their energy. Energy may shrink in collisions; what it grew by is the most in one step, as a share.

                ![Speed against overlap](steps.svg)

                | scene | step | engine | steps a second | deepest overlap, m | tunnelled | stopped | energy grew by | energy drift at the end |
                |---|--:|---|--:|--:|--:|--:|--:|--:|
                """);
        rows.forEach(row -> page.append(line(row)).append('\n'));
        page.append("""

                `mvn -q test-compile exec:java -Dexec.classpathScope=test \
                -Dexec.mainClass=robosim.geometry.bench.dynamics.SideBySide -Dpublish` writes this page.
                """);
        Files.writeString(REPORT.resolve("steps.md"), page);
    }

    private static double speed(Row row) {
        return row.step * 1e9 / row.nanos;
    }

    private static Series series(List<Row> rows, SideScene scene, boolean isOwn) {
        List<Dot> dots = rows.stream()
                .filter(row -> row.scene == scene && row.isOwn == isOwn)
                .map(row -> new Dot(row.run.deepest, speed(row), milliseconds(row.step)))
                .toList();
        return isOwn
                ? new Series("this module", 0, Marker.CIRCLE, Line.NONE, false, dots)
                : new Series("dyn4j", 7, Marker.DIAMOND, Line.SOLID, false, dots);
    }
}

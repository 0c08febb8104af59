package robosim.geometry.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.IntFunction;
import robosim.geometry.Geometry;
import robosim.geometry.Snapshot;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.sweep.ParameterSweep;
import robosim.geometry.sweep.Replicate;
import robosim.geometry.sweep.Result;
import robosim.geometry.sweep.SweepRun;
import robosim.geometry.sweep.SweepScenario;
import robosim.geometry.sweep.SweepWorld;

/**
 * One snapshot for many: queries a second on threads, what a world made of it takes beside one that is built, replicates of
 * a sweep a second, and how all of that grows with static objects and with robots. Threads are measured in turn; the
 * best of the rounds counts. On a machine that does other things too, the share of the threads is told by the processors'
 * own time: whether they hold each other up.
 *
 * <p>{@code mvn -q test-compile exec:java -Dexec.classpathScope=test -Dexec.mainClass=robosim.geometry.bench.Scale}, with
 * {@code -Dparts=threads,memory,sweep,objects,robots} for some, and {@code -Dthreads=2} for how many. Memory wants a heap:
 * {@code MAVEN_OPTS=-Xmx3g}.
 */
public final class Scale {
    private static final int OBJECTS = 100_000;
    private static final int ROBOTS = 10;
    private static final int WORLDS = 1000;
    private static final int ROUNDS = 7;
    private static final ThreadMXBean CPU = ManagementFactory.getThreadMXBean();

    private Scale() {}

    /** Measures what the properties ask for. */
    public static void main(String[] args) throws Exception {
        List<String> parts = List.of(System.getProperty("parts", "threads,memory,sweep,objects,robots")
                .split(",", -1));
        int threads = Integer.getInteger("threads", 2);
        if (parts.contains("threads")) {
            threads(threads);
        }
        if (parts.contains("memory")) {
            memory();
        }
        if (parts.contains("sweep")) {
            sweep(threads);
        }
        if (parts.contains("objects")) {
            objects();
        }
        if (parts.contains("robots")) {
            robots();
        }
    }

    private static Geometry world(int objects, int robots) {
        Scene scene = new Scene(objects, 2);
        double side = scene.side() + 20;
        Geometry world = new Geometry(side, 10, side, Dimension.PLANAR, Accuracy.EXACT);
        scene.objects(objects).forEach(world::addObjectUnchecked);
        for (int k = 0; k < robots; k++) {
            CylinderObject robot = new CylinderObject(new Point(), 0.3, 2).moveable("robot " + k);
            world.addObjectUnchecked(robot.movedTo(new Point(scene.coordinate(), 0, scene.coordinate())));
        }
        return world;
    }

    private static long ask(Geometry world, int rays, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double half = world.width() / 2 - 10;
        long hits = 0;
        for (int k = 0; k < rays; k++) {
            Ray ray = new Ray(
                    new Point(random.nextDouble(-half, half), 0, random.nextDouble(-half, half)),
                    new Point(random.nextDouble(-1, 1), 0, random.nextDouble(-1, 1)));
            hits += world.getRayDistance(ray, 0, 100, 0) < 100 ? 1 : 0;
        }
        return hits;
    }

    /** Rays a second on 1 thread and on more, each with a world of its own from one snapshot. */
    private static void threads(int most) throws Exception {
        Snapshot snapshot = world(OBJECTS, ROBOTS).snapshot();
        int rays = 300_000;
        double[] best = new double[most + 1];
        double[] bestOfProcessor = new double[most + 1];
        for (int round = 0; round < ROUNDS; round++) {
            for (int threads = 1; threads <= most; threads++) {
                Spent spent = together(threads, k -> {
                    Geometry world = snapshot.toGeometry();
                    ask(world, 1000, k);
                    return () -> ask(world, rays, k);
                });
                best[threads] = Math.max(best[threads], threads * rays / spent.seconds);
                double own = threads * rays / (spent.ofProcessors / threads);
                bestOfProcessor[threads] = Math.max(bestOfProcessor[threads], own);
            }
        }
        for (int threads = 1; threads <= most; threads++) {
            Timing.print(
                    "threads %d: %.0f rays a second among %d objects, %.2f x one thread; by the processors' own time %.2f x",
                    threads,
                    best[threads],
                    OBJECTS,
                    best[threads] / best[1],
                    bestOfProcessor[threads] / bestOfProcessor[1]);
        }
    }

    /** From when all threads are ready until the last is done; on a busy machine the processors' own time is the smaller. */
    private record Spent(double seconds, double ofProcessors) {}

    private static Spent together(int threads, IntFunction<Runnable> work) throws Exception {
        LongAdder nanos = new LongAdder();
        CyclicBarrier ready = new CyclicBarrier(threads + 1);
        List<Thread> all = new ArrayList<>();
        for (int k = 0; k < threads; k++) {
            int number = k;
            Thread thread = new Thread(() -> {
                Runnable own = work.apply(number);
                try {
                    ready.await();
                } catch (Exception e) {
                    throw new IllegalStateException(e);
                }
                long before = CPU.getCurrentThreadCpuTime();
                own.run();
                nanos.add(CPU.getCurrentThreadCpuTime() - before);
            });
            thread.start();
            all.add(thread);
        }
        ready.await();
        long start = System.nanoTime();
        for (Thread thread : all) {
            thread.join();
        }
        return new Spent((System.nanoTime() - start) / 1e9, nanos.sum() / 1e9);
    }

    /** What is alive, in bytes. */
    private static long used() throws InterruptedException {
        Runtime runtime = Runtime.getRuntime();
        long least = Long.MAX_VALUE;
        for (int k = 0; k < 4; k++) {
            System.gc();
            Thread.sleep(50);
            least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
        }
        return least;
    }

    /** 1,000 worlds that share one static tree, each asked and moved in, beside one world that was built. */
    private static void memory() throws Exception {
        long empty = used();
        List<Geometry> kept = new ArrayList<>(List.of(world(OBJECTS, ROBOTS)));
        ask(kept.get(0), 100, 1);
        long one = used() - empty;
        Timing.print("memory: one world of %d objects and %d robots takes %.1f MB", OBJECTS, ROBOTS, one / 1e6);
        Snapshot snapshot = kept.remove(0).snapshot();
        long shared = used() - empty;
        Timing.print("memory: its snapshot takes %.1f MB", shared / 1e6);
        kept.addAll(snapshot.toGeometries(WORLDS));
        kept.forEach(Scale::use);
        print("for one thread (toGeometries)", used() - empty, shared, one);
        kept.clear();
        for (int k = 0; k < WORLDS; k++) {
            kept.add(snapshot.toGeometry());
        }
        kept.forEach(Scale::use);
        print("for any threads (toGeometry)", used() - empty, shared, one);
        if (kept.size() != WORLDS || snapshot.size() == 0) {
            throw new IllegalStateException("all must still be there");
        }
    }

    private static void use(Geometry world) {
        ask(world, 10, 1);
        for (int k = 0; k < ROBOTS; k++) {
            world.simpleMove("robot " + k, 0.1, 0, 0);
        }
    }

    private static void print(String which, long all, long shared, long one) {
        Timing.print(
                "memory: snapshot and %d worlds of it %s take %.1f MB, %.2f x one world; %.1f kB for each world",
                WORLDS, which, all / 1e6, (double) all / one, (all - shared) / 1e3 / WORLDS);
    }

    /** A robot that goes around. */
    private static final class Errand implements SweepScenario {
        private static final long serialVersionUID = 1;

        @Override
        public Result run(Replicate replicate) {
            Geometry world = replicate.world();
            double near = 0;
            for (int k = 0; k < 2000; k++) {
                String robot = "robot " + k % ROBOTS;
                world.simpleTurn(robot, replicate.random().nextDouble(-20, 20));
                world.simpleMove(robot, 0.1, 0, 0);
                near += Math.min(50, world.getSonarDistance(robot, 1, 0, 0, 50, 0));
            }
            return Result.of("distance", near);
        }
    }

    private static void sweep(int most) throws IOException, InterruptedException {
        ParameterSweep sweep = ParameterSweep.of(new Errand())
                .over(new SweepWorld("scene", world(OBJECTS, ROBOTS).snapshot()))
                .replicates(1000);
        double[] best = new double[most + 1];
        String digest = "";
        for (int round = 0; round < 3; round++) {
            for (int threads = 1; threads <= most; threads++) {
                Path file = Files.createTempFile("scale", ".jsonl");
                long start = System.nanoTime();
                String found = SweepRun.of(sweep, file)
                        .resume()
                        .withThreads(threads)
                        .run()
                        .digest();
                best[threads] = Math.max(best[threads], sweep.size() / ((System.nanoTime() - start) / 1e9));
                Files.delete(file);
                if (!digest.isEmpty() && !digest.equals(found)) {
                    throw new IllegalStateException("results must be the same on any number of threads");
                }
                digest = found;
            }
        }
        for (int threads = 1; threads <= most; threads++) {
            Timing.print(
                    "sweep on %d threads: %.0f replicates a second of 2,000 steps among %d objects, %.2f x one thread",
                    threads, best[threads], OBJECTS, best[threads] / best[1]);
        }
    }

    private static void objects() {
        for (int count = 1000; count <= 1_000_000; count *= 10) {
            long start = System.nanoTime();
            Geometry world = world(count, ROBOTS);
            double build = (System.nanoTime() - start) / 1e6;
            start = System.nanoTime();
            Snapshot snapshot = world.snapshot();
            double freeze = (System.nanoTime() - start) / 1e6;
            print("objects " + count, snapshot, build, freeze, ROBOTS);
        }
    }

    private static void robots() {
        for (int count = 10; count <= 10_000; count *= 10) {
            long start = System.nanoTime();
            Geometry world = world(10_000, count);
            double build = (System.nanoTime() - start) / 1e6;
            start = System.nanoTime();
            Snapshot snapshot = world.snapshot();
            double freeze = (System.nanoTime() - start) / 1e6;
            print("10000 objects, robots " + count, snapshot, build, freeze, count);
        }
    }

    private static void print(String what, Snapshot snapshot, double build, double freeze, int robots) {
        double copy = Double.POSITIVE_INFINITY;
        double ray = Double.POSITIVE_INFINITY;
        double move = Double.POSITIVE_INFINITY;
        int copies = Math.max(5, 2000 / robots);
        for (int round = 0; round < ROUNDS; round++) {
            long start = System.nanoTime();
            Geometry last = snapshot.toGeometry();
            for (int k = 1; k < copies; k++) {
                last = snapshot.toGeometry();
            }
            copy = Math.min(copy, (System.nanoTime() - start) / 1e3 / copies);
            ask(last, 1000, 1);
            start = System.nanoTime();
            ask(last, 50_000, round);
            ray = Math.min(ray, (System.nanoTime() - start) / 50_000.0);
            SplittableRandom random = new SplittableRandom(round);
            start = System.nanoTime();
            for (int k = 0; k < 50_000; k++) {
                last.simpleMove("robot " + k % robots, random.nextDouble(-0.2, 0.2), 0, random.nextDouble(-0.2, 0.2));
            }
            move = Math.min(move, (System.nanoTime() - start) / 50_000.0);
        }
        Timing.print(
                "%s: built in %.0f ms, snapshot in %.0f ms; of it a world in %.1f us, a ray in %.0f ns, a move in %.0f ns",
                what, build, freeze, copy, ray, move);
    }
}

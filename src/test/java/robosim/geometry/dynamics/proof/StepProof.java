package robosim.geometry.dynamics.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.StopCount;
import robosim.geometry.proof.Witnesses;

/** Runs many small scenes, step by step, and looks at each after every step. What comes of a scene depends on its seed alone. */
public final class StepProof {
    /** Steps of a scene. */
    static final int STEPS = 40;

    /** Bodies are stirred every so many steps. */
    private static final int STIRRED = 8;

    /** At most so many failures are kept. */
    private static final int MOST_FAILURES = 20;

    private static final long TOLD = 10_000_000_000L;

    private final List<StepFamily> families;
    private final long scenes;
    private final boolean isTold;
    private final long start = System.nanoTime();
    private final AtomicLong toldAt = new AtomicLong(System.nanoTime());
    private final AtomicLong done = new AtomicLong();

    final AtomicLong digest = new AtomicLong();
    final AtomicLong contacts = new AtomicLong();
    final AtomicReference<Witnesses.Counts> proofs = new AtomicReference<>(Witnesses.Counts.NONE);
    final StopCount stopped = new StopCount();
    final AtomicLong slowest = new AtomicLong();
    final AtomicLong bodies = new AtomicLong();
    volatile String slowestAt = "";
    final long[] nanos = new long[StepFamily.values().length];
    final long[] stepsOf = new long[StepFamily.values().length];
    final StopCount[] stops = new StopCount[StepFamily.values().length];
    final List<String> failures = new CopyOnWriteArrayList<>();

    StepProof(List<StepFamily> families, long steps, boolean isTold) {
        this.families = families;
        scenes = Math.max(families.size(), (steps + STEPS - 1) / STEPS);
        this.isTold = isTold;
        Arrays.setAll(stops, k -> new StopCount());
    }

    long steps() {
        return done.get();
    }

    /** Runs all on so many threads. */
    StepProof run(int threads) {
        ForkJoinPool pool = new ForkJoinPool(threads);
        try {
            pool.submit(() -> LongStream.range(0, scenes).parallel().forEach(this::scene))
                    .join();
        } finally {
            pool.shutdown();
        }
        return this;
    }

    private void scene(long number) {
        StepFamily family = families.get((int) (number % families.size()));
        long begin = System.nanoTime();
        String broken = run(family, number);
        synchronized (this) {
            nanos[family.ordinal()] += System.nanoTime() - begin;
            stepsOf[family.ordinal()] += STEPS;
        }
        if (broken != null && failures.size() < MOST_FAILURES) {
            failures.add(broken);
            if (isTold) {
                System.out.println(broken);
            }
        }
    }

    /** Runs a scene, and tells the first thing that is broken. */
    @Nullable
    String run(StepFamily family, long number) {
        SplittableRandom random = new SplittableRandom(number);
        StepScene scene = family.make(random);
        bodies.addAndGet(scene.names.size());
        long hash = number;
        double energy = Double.POSITIVE_INFINITY;
        String broken = scene.broken();
        if (broken != null) {
            throw new IllegalStateException(family + ", scene " + number + " begins broken: " + broken);
        }
        Witnesses witnesses = new Witnesses(number);
        for (int step = 0; step < STEPS; step++) {
            if (step % STIRRED == 0) {
                family.stir(scene, random);
                energy = family.isDriven() ? Double.POSITIVE_INFINITY : scene.energy();
            }
            double seconds = family.seconds(scene, random);
            long before = System.nanoTime();
            scene.dynamics.advance(seconds);
            long took = System.nanoTime() - before;
            if (took > slowest.get()) {
                slowest.set(took);
                slowestAt = family + ", scene " + number + ", step " + step;
            }
            var result = scene.dynamics.last();
            contacts.addAndGet(result.contacts().size());
            String when = family + ", scene " + number + ", step " + step;
            stops[family.ordinal()].add(result, scene.names.size(), when);
            stopped.add(result, scene.names.size(), when);
            hash = scene.digest(hash);
            if (broken == null) {
                broken = scene.broken();
                broken = broken == null ? witnesses.clear(scene.world, scene.names) : broken;
                double now = scene.energy();
                if (broken == null && !(now <= energy * (1 + 1e-9) + 1e-9)) {
                    broken = "energy grew from " + energy + " to " + now;
                }
                energy = family.isDriven() ? Double.POSITIVE_INFINITY : now;
                broken = broken == null ? null : family + ", scene " + number + ", step " + step + ": " + broken;
            }
            tell(done.incrementAndGet());
        }
        digest.addAndGet(hash);
        proofs.accumulateAndGet(witnesses.counts(), Witnesses.Counts::plus);
        return broken;
    }

    private void tell(long now) {
        long last = toldAt.get();
        long time = System.nanoTime();
        if (isTold && time - last > TOLD && toldAt.compareAndSet(last, time)) {
            System.out.printf(
                    Locale.ROOT,
                    "%,d of %,d steps (%.1f %%), %,.0f a second, %,d contacts, %s, slowest %.0f ms (%s),"
                            + " %d failures%n",
                    now,
                    scenes * STEPS,
                    100.0 * now / (scenes * STEPS),
                    now / ((time - start) * 1e-9),
                    contacts.get(),
                    stopped,
                    slowest.get() * 1e-6,
                    slowestAt,
                    failures.size());
        }
    }

    /** What came of it, a line for each family. */
    String summary() {
        StringBuilder lines = new StringBuilder();
        for (StepFamily family : StepFamily.values()) {
            long each = stepsOf[family.ordinal()];
            if (each == 0) {
                continue;
            }
            lines.append(String.format(
                    Locale.ROOT,
                    "%-11s %,d steps, %.0f us a step, %s%n",
                    family,
                    each,
                    nanos[family.ordinal()] * 1e-3 / each,
                    stops[family.ordinal()]));
        }
        lines.append(String.format(
                Locale.ROOT,
                "%,d steps of %.1f bodies, %,d contacts, slowest step %.0f ms (%s), digest %016x, %d failures%n",
                steps(),
                (double) bodies.get() / scenes,
                contacts.get(),
                slowest.get() * 1e-6,
                slowestAt,
                digest.get(),
                failures.size()));
        lines.append("of a share of the steps ").append(proofs.get()).append(System.lineSeparator());
        failures.forEach(failure -> lines.append(failure).append(System.lineSeparator()));
        return lines.toString();
    }

    /** Runs {@code -Ddynamics.steps} steps of all families on {@code -Ddynamics.threads} threads and tells how far it is. */
    public static void main(String[] args) {
        String family = System.getProperty("dynamics.family", "");
        List<StepFamily> families = family.isEmpty() ? all() : Collections.singletonList(StepFamily.valueOf(family));
        String one = System.getProperty("dynamics.scene", "");
        if (!one.isEmpty()) {
            System.out.println(new StepProof(families, 0, false).run(families.get(0), Long.parseLong(one)));
            return;
        }
        StepProof proof = new StepProof(families, Long.getLong("dynamics.steps", 100_000), true)
                .run(Integer.getInteger("dynamics.threads", 1));
        System.out.print(proof.summary());
    }

    /** All families, those whose steps take long less often. */
    static List<StepFamily> all() {
        List<StepFamily> all = new ArrayList<>();
        for (StepFamily family : StepFamily.values()) {
            all.addAll(Collections.nCopies(family.isSlow() ? 1 : 3, family));
        }
        return all;
    }
}

package robosim.geometry.dynamics.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import robosim.geometry.dynamics.StopCount;
import robosim.geometry.proof.Witnesses;

/** Runs many small scenes, step by step, and looks at each after every step. What comes of a scene depends on its seed alone. */
final class StepProof {
    /** Steps of a scene. */
    static final int STEPS = 40;

    /** Bodies are stirred every so many steps. */
    private static final int STIRRED = 8;

    /** At most so many failures are kept. */
    private static final int MOST_FAILURES = 20;

    private final List<StepFamily> families;
    private final long scenes;

    final AtomicLong digest = new AtomicLong();
    final AtomicLong contacts = new AtomicLong();
    final StopCount stopped = new StopCount();
    final StopCount[] stops = new StopCount[StepFamily.values().length];
    final List<String> failures = new CopyOnWriteArrayList<>();

    StepProof(List<StepFamily> families, long steps) {
        this.families = families;
        scenes = Math.max(families.size(), (steps + STEPS - 1) / STEPS);
        Arrays.setAll(stops, k -> new StopCount());
    }

    long steps() {
        return scenes * STEPS;
    }

    StepProof run(boolean isParallel) {
        LongStream numbers = LongStream.range(0, scenes);
        (isParallel ? numbers.parallel() : numbers).forEach(number -> {
            String broken = run(families.get((int) (number % families.size())), number);
            if (broken != null && failures.size() < MOST_FAILURES) {
                failures.add(broken);
            }
        });
        return this;
    }

    /** Runs a scene, and tells the first thing that is broken. */
    @Nullable
    String run(StepFamily family, long number) {
        SplittableRandom random = new SplittableRandom(number);
        StepScene scene = family.make(random);
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
            scene.dynamics.advance(family.seconds(scene, random));
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
                broken = broken == null ? null : when + ": " + broken;
            }
        }
        digest.addAndGet(hash);
        return broken;
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

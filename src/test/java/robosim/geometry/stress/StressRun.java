package robosim.geometry.stress;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/** Asks families so many cases on so many threads; the result depends on the seed and the numbers of cases alone. */
final class StressRun {
    private static final long PROGRESS_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final long seed;
    private final int threads;
    private final PrintStream out;
    private final boolean isLong;
    private final long begun = System.nanoTime();
    private final AtomicLong said = new AtomicLong(begun);

    /**
     * @param isLong whether to say every few seconds how far it is
     */
    StressRun(long seed, int threads, PrintStream out, boolean isLong) {
        this.seed = seed;
        this.threads = threads;
        this.out = out;
        this.isLong = isLong;
        if (isLong) {
            out.printf("seed %d, %d threads%n", seed, threads);
        }
    }

    List<Tally> run(List<Family> families, long random, long adversarial) {
        List<Tally> tallies = new ArrayList<>();
        for (Family family : families) {
            tallies.add(run(family, false, random));
            tallies.add(run(family, true, adversarial));
        }
        return tallies;
    }

    /** One sort of one family. */
    Tally run(Family family, boolean adversarial, long cases) {
        int chunks = Math.toIntExact((cases + Chunk.CASES - 1) / Chunk.CASES);
        Tally[] parts = new Tally[chunks];
        AtomicInteger next = new AtomicInteger();
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<Future<?>> workers = new ArrayList<>();
            for (int k = 0; k < threads; k++) {
                workers.add(pool.submit(() -> {
                    for (int c = next.getAndIncrement(); c < chunks; c = next.getAndIncrement()) {
                        int count = (int) Math.min(Chunk.CASES, cases - (long) c * Chunk.CASES);
                        parts[c] = Chunk.run(family, adversarial, seed, c, count);
                        progress(family, adversarial, (long) c * Chunk.CASES + count, cases);
                    }
                }));
            }
            for (Future<?> worker : workers) {
                worker.get();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted in " + family.name(), e);
        } catch (ExecutionException e) {
            throw new IllegalStateException("failed in " + family.name(), e.getCause());
        } finally {
            pool.shutdownNow();
        }
        Tally tally = Arrays.stream(parts).reduce(Tally::plus).orElseThrow();
        if (isLong || tally.wrong() > 0) {
            say(tally);
        }
        return tally;
    }

    private void progress(Family family, boolean adversarial, long done, long of) {
        long last = said.get();
        long now = System.nanoTime();
        if (isLong && now - last > PROGRESS_NANOS && said.compareAndSet(last, now)) {
            out.printf(
                    "%5d s  %s, %s: %,d of %,d%n",
                    (now - begun) / 1_000_000_000, family.name(), adversarial ? "adversarial" : "random", done, of);
        }
    }

    private void say(Tally tally) {
        out.printf(
                "%5d s  %s, %s: %d wrong of %,d (%s), %.0f %% yes, %.0f ns a case%n",
                (System.nanoTime() - begun) / 1_000_000_000,
                tally.family(),
                tally.adversarial() ? "adversarial" : "random",
                tally.wrong(),
                tally.cases(),
                tally.wrong() == 0 ? String.format("rate below %.1e", tally.bound()) : "WRONG",
                100 * tally.share(),
                tally.nanosEach());
        tally.failures().forEach(out::println);
    }
}

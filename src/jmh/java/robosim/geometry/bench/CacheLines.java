package robosim.geometry.bench;

import java.util.SplittableRandom;
import java.util.function.IntToDoubleFunction;

/**
 * How many cache lines a query waits for, one after the other, estimated by time: what it takes longer right after the caches
 * were swept than when it has just been asked, over what one read of memory takes longer. Lines that are fetched at the same
 * time count as one; those of its code count too. What an empty query takes longer is subtracted.
 */
final class CacheLines {
    private static final int QUERIES = 60;
    private static final int REPEATS = 10;
    private static final int LONGS = 1 << 24;
    private static final int LINE = 8;

    private static final int CHASED = 64;
    private static final int CHAINS = 1 << 22;

    private final long[] memory = new long[LONGS];
    private final SplittableRandom random = new SplittableRandom(7);
    private final int[] chain = random.ints(CHAINS, 0, CHAINS).toArray();
    private double sum;

    private CacheLines() {}

    /** Lines a query, the median over some of so many queries. */
    static double of(int queries, IntToDoubleFunction ask) {
        CacheLines lines = new CacheLines();
        double empty = lines.extra(1, k -> k);
        double line = (lines.extra(CHAINS, lines::chase) - empty) / CHASED;
        double query = lines.extra(queries, ask) - empty;
        return line > 0 ? Math.max(0, query / line) : Double.NaN;
    }

    /** Reads so many lines far apart of which each tells where the next is. */
    private double chase(int from) {
        int at = from;
        for (int k = 0; k < CHASED; k++) {
            at = chain[at];
        }
        return at;
    }

    /** How many nanoseconds longer a query takes right after the caches were swept. */
    private double extra(int queries, IntToDoubleFunction ask) {
        double[] extras = new double[QUERIES];
        for (int q = 0; q < QUERIES; q++) {
            int k = random.nextInt(queries);
            long warm = Long.MAX_VALUE;
            for (int repeat = 0; repeat < REPEATS; repeat++) {
                warm = Math.min(warm, time(k, ask));
            }
            evict();
            extras[q] = time(k, ask) - warm;
        }
        if (sum == 42) {
            System.out.print(""); // the sum is used
        }
        return Timing.median(extras);
    }

    private long time(int k, IntToDoubleFunction ask) {
        long start = System.nanoTime();
        sum += ask.applyAsDouble(k);
        return System.nanoTime() - start;
    }

    private void evict() {
        for (int k = 0; k < LONGS; k += LINE) {
            memory[k]++;
        }
    }
}

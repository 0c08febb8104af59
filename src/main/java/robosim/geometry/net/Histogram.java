package robosim.geometry.net;

import java.util.concurrent.atomic.AtomicLongArray;

/**
 * A histogram of durations with 16 classes per doubling, so that quantiles are accurate to a 16th, however long the
 * durations. Counting allocates nothing and does not block.
 */
final class Histogram {
    private static final int BITS = 4;
    private static final int STEPS = 1 << BITS;

    private final AtomicLongArray counts = new AtomicLongArray((Long.SIZE - BITS) * STEPS);

    /** Counts a duration. */
    void add(long nanos) {
        counts.incrementAndGet(index(Math.max(0, nanos)));
    }

    private static int index(long nanos) {
        if (nanos < STEPS) {
            return (int) nanos;
        }
        int shift = Long.SIZE - 1 - BITS - Long.numberOfLeadingZeros(nanos);
        return (shift << BITS) + (int) (nanos >>> shift);
    }

    /** The greatest duration of a class. */
    private static long most(int index) {
        if (index < STEPS) {
            return index;
        }
        int shift = (index >>> BITS) - 1;
        long next = (index & STEPS - 1) + STEPS + 1L;
        return (next << shift) - 1;
    }

    /**
     * A quantile: a duration that the given fraction of all durations does not exceed, at most a 16th above the
     * smallest such; 0 if there is none.
     */
    long quantile(double share) {
        long total = 0;
        for (int k = 0; k < counts.length(); k++) {
            total += counts.get(k);
        }
        long wanted = (long) Math.ceil(share * total);
        long seen = 0;
        for (int k = 0; k < counts.length(); k++) {
            seen += counts.get(k);
            if (seen >= wanted && seen > 0) {
                return most(k);
            }
        }
        return 0;
    }
}

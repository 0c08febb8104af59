package robosim.geometry.net;

import java.util.concurrent.atomic.AtomicLongArray;

/**
 * How often which time was taken: 16 classes for each doubling, so that a quantile is told within a 16th, however long
 * the times. Counting allocates nothing and waits for nobody.
 */
final class Histogram {
    private static final int BITS = 4;
    private static final int STEPS = 1 << BITS;

    private final AtomicLongArray counts = new AtomicLongArray((Long.SIZE - BITS) * STEPS);

    /** Counts a time. */
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

    /** The greatest time of a class. */
    private static long most(int index) {
        if (index < STEPS) {
            return index;
        }
        int shift = (index >>> BITS) - 1;
        long next = (index & STEPS - 1) + STEPS + 1L;
        return (next << shift) - 1;
    }

    /** A time that a share of all times does not exceed, at most a 16th above the least such; 0 where there was none. */
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

package robosim.geometry.sweep;

import java.util.random.RandomGenerator;
import robosim.geometry.check.Checks;

/**
 * A random generator that gives the same bits on every JVM for a seed: SplitMix64 (Steele, Lea and Flood 2014). The
 * methods implemented here will never change; the others of {@link RandomGenerator} are the JDK's and may change with
 * it.
 */
final class SeededRandom implements RandomGenerator {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private long state;
    private double spare;
    private boolean hasSpare;

    /** A generator at the beginning of its stream. */
    SeededRandom(long seed) {
        state = seed;
    }

    @Override
    public long nextLong() {
        state += GOLDEN;
        return Seeds.mix(state);
    }

    @Override
    public int nextInt() {
        return (int) (nextLong() >>> 32);
    }

    /** A uniformly distributed whole number from 0 up to, not including, a bound above 0. */
    @Override
    public int nextInt(int bound) {
        Checks.refuse(bound <= 0, "bound must be above 0", bound);
        // 31 random bits are restricted to a multiple of the bound, so that all results are equally likely.
        int most = Integer.MAX_VALUE - (int) ((Integer.MAX_VALUE - bound + 1L) % bound);
        int drawn = (int) (nextLong() >>> 33);
        while (drawn > most) {
            drawn = (int) (nextLong() >>> 33);
        }
        return drawn % bound;
    }

    @Override
    public boolean nextBoolean() {
        return nextLong() < 0;
    }

    /** A multiple of 2<sup>-53</sup> from 0 up to, not including, 1. */
    @Override
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1p-53;
    }

    /** A number from {@code from} up to {@code to}, which rounding may reach. */
    @Override
    public double nextDouble(double from, double to) {
        if (!(from < to && to - from < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "from must be below to, and both finite (got: " + from + " and " + to + ")");
        }
        return from + nextDouble() * (to - from);
    }

    /** Normally distributed about 0 with a standard deviation of 1: Marsaglia's polar method. */
    @Override
    public double nextGaussian() {
        if (hasSpare) {
            hasSpare = false;
            return spare;
        }
        double u;
        double v;
        double square;
        do {
            u = 2 * nextDouble() - 1;
            v = 2 * nextDouble() - 1;
            square = u * u + v * v;
        } while (square >= 1 || square == 0);
        double scale = Math.sqrt(-2 * StrictMath.log(square) / square);
        spare = v * scale;
        hasSpare = true;
        return u * scale;
    }
}

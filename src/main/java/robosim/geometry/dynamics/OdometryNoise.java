package robosim.geometry.dynamics;

import robosim.geometry.exact.Degrees;

/** Random numbers that depend on their key alone: SplitMix64 (Steele, Lea and Flood 2014) over what is mixed in. */
final class OdometryNoise {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    /** Ends a name; not a UTF-16 code unit. */
    private static final long END = 0x10000;

    private OdometryNoise() {}

    /** The state from which the draws of a step are made. */
    static long start(long seed, String robot, long step) {
        long state = mix(seed);
        for (int k = 0; k < robot.length(); k++) {
            state = mix(state ^ robot.charAt(k));
        }
        return mix(mix(state ^ END) ^ step);
    }

    /** One of the independent normal deviates of a state, by the method of Box and Muller 1958. */
    static double normal(long state, int draw) {
        // Above 0, so that it has a logarithm, and at most 1.
        double u = ((mix(state + 2L * draw) >>> 11) + 1) * 0x1p-53;
        double v = (mix(state + 2L * draw + 1) >>> 11) * 0x1p-53;
        return Math.sqrt(-2 * StrictMath.log(u)) * Degrees.cos(360 * v);
    }

    private static long mix(long word) {
        long z = word + GOLDEN;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}

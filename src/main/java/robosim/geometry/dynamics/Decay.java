package robosim.geometry.dynamics;

/**
 * What becomes in a time t of a speed v that falls at a rate c while an acceleration a acts, {@code v' = a - c v}, with
 * {@code x = c t}: the exact solution. Nothing here allocates; unlike the sine, StrictMath's exponential uses no array on any JDK.
 */
final class Decay {
    /** Below this the series of {@link #meanGain} is used, whose first term left out is less than 2^-53 of the sum. */
    private static final double SMALL = 0x1p-6;

    private Decay() {}

    /** The share of v that is left after the time: {@code exp(-x)}; exactly 1 for 0. */
    static double kept(double x) {
        return x == 0 ? 1 : StrictMath.exp(-x);
    }

    /** The mean of that share over the time, which is also the share of {@code a t} that is gained: {@code (1 - exp(-x)) / x}. */
    static double mean(double x) {
        return x == 0 ? 1 : -StrictMath.expm1(-x) / x;
    }

    /** What is left at the end of the mean over the time: {@code kept(x) / mean(x)}. */
    static double rest(double x) {
        return x == 0 ? 1 : x * kept(x) / -StrictMath.expm1(-x);
    }

    /** What is gained at the end beyond {@link #rest} of the mean gain, as a share of {@code a t}; half of it for 0. */
    static double restGain(double x) {
        return mean(x) - rest(x) * meanGain(x);
    }

    /** The mean over the time of what is gained, as a share of {@code a t}: {@code (1 - mean(x)) / x}; half of it for 0. */
    static double meanGain(double x) {
        if (x < SMALL) {
            return 1.0 / 2
                    - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x * (1.0 / 5040 - x / 40320)))));
        }
        return (1 - mean(x)) / x;
    }
}

package robosim.geometry.census;

import org.jspecify.annotations.Nullable;

/**
 * How one case came out. The three numbers are shares of the documented bound: above 1 the claim is broken.
 *
 * @param regime  one of the kernel's regimes
 * @param early   how much too early, too near or too small the answer is; 0 where it is not
 * @param late    how much too late, too far or too large it is; 0 where it is not
 * @param width   how wide the product's own bracket is; 0 where it has none
 * @param failure the case and both answers, to paste into a test, where any of the three is above 1 or a verdict is wrong;
 *     else null
 */
public record Visit(
        String regime,
        double early,
        double late,
        double width,
        @Nullable String failure) {
    /** A verdict that is right. */
    public static Visit right(String regime) {
        return new Visit(regime, 0, 0, 0, null);
    }

    /** A verdict that is wrong. */
    public static Visit wrong(String regime, String failure) {
        return new Visit(regime, 0, 0, 0, failure);
    }

    /** A number; {@code paste} is asked only where the claim is broken. */
    public static Visit number(
            String regime, double early, double late, double width, java.util.function.Supplier<String> paste) {
        boolean holds = early <= 1 && late <= 1 && width <= 1; // written so that NaN does not hold
        return new Visit(regime, early, late, width, holds ? null : paste.get());
    }
}

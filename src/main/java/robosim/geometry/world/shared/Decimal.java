package robosim.geometry.world.shared;

import java.math.BigDecimal;
import java.math.MathContext;
import robosim.geometry.check.NumberText;

/** Doubles in decimal notation: the fewest digits that read back to the same bits, the same on every JDK. */
public final class Decimal {
    /** A decimal with at most this many digits is the shortest one of its double. */
    private static final int SURE = 15;

    private Decimal() {}

    /** A finite number as text, as in {@code 5}, {@code 0.0001}, {@code 1.5e-9}. */
    public static String of(double value) {
        long whole = (long) value;
        if (whole == value && whole != 0 && Math.abs(whole) < 1_000_000_000_000_000L) {
            return Long.toString(whole);
        }
        if (value == 0) {
            return 1 / value < 0 ? "-0" : "0";
        }
        return NumberText.of(shortest(value));
    }

    private static BigDecimal shortest(double value) {
        BigDecimal text = new BigDecimal(Double.toString(value)).stripTrailingZeros();
        if (text.precision() <= SURE) {
            return text;
        }
        // Before JDK 19 Double.toString gives some numbers a digit too many, or not the nearest ones (JDK-4511638).
        BigDecimal exact = new BigDecimal(value);
        BigDecimal shortest = text;
        for (int digits = text.precision(); digits >= SURE; digits--) {
            BigDecimal shorter = exact.round(new MathContext(digits)).stripTrailingZeros();
            if (shorter.doubleValue() != value) {
                break;
            }
            shortest = shorter;
        }
        return shortest;
    }
}

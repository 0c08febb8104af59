package robosim.geometry.cli;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Formats numbers in texts for people. */
final class NumberText {
    private static final MathContext DIGITS = new MathContext(6);

    private NumberText() {}

    /** A count with its noun, as in {@code 1 step} and {@code 3,000 steps}. */
    static String count(long count, String one) {
        return String.format(Locale.ROOT, "%,d %s%s", count, one, count == 1 ? "" : "s");
    }

    /** A number to six digits, without trailing zeros. */
    static String number(double value) {
        if (!Double.isFinite(value) || value == 0) {
            return value == 0 ? "0" : String.valueOf(value);
        }
        BigDecimal rounded = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
        double size = Math.abs(value);
        return size >= 1e-6 && size < 1e15
                ? rounded.toPlainString()
                : rounded.toString().replace("E+", "e").replace('E', 'e');
    }
}

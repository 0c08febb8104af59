package robosim.geometry.check;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;

/**
 * Numbers as people read them: rounded, without needless zeros, the same text on every JVM. As in {@code 0.25}, {@code 12}
 * and, from 10<sup>15</sup> on and below a millionth, {@code 1.5e-9}.
 */
public final class NumberText {
    private static final int LEAST_EXPONENT = -5;
    private static final int MOST_EXPONENT = 15;

    private NumberText() {}

    /** To so many digits at most. */
    public static String digits(double value, int digits) {
        return Double.isFinite(value)
                ? of(new BigDecimal(value).round(new MathContext(digits)))
                : String.valueOf(value);
    }

    /** To so many places behind the point at most. */
    public static String places(double value, int places) {
        return Double.isFinite(value)
                ? of(new BigDecimal(value).setScale(places, RoundingMode.HALF_EVEN))
                : String.valueOf(value);
    }

    /** All digits of a number that has been rounded. */
    public static String of(BigDecimal value) {
        BigDecimal plain = value.stripTrailingZeros();
        int exponent = plain.precision() - plain.scale();
        boolean isReadable = plain.signum() == 0 || (exponent >= LEAST_EXPONENT && exponent <= MOST_EXPONENT);
        return isReadable
                ? plain.toPlainString()
                : plain.toString().replace("E+", "e").replace('E', 'e');
    }

    /** A count with its noun, as in {@code 1 step} and {@code 3,000 steps}. */
    public static String count(long count, String one) {
        return String.format(Locale.ROOT, "%,d %s%s", count, one, count == 1 ? "" : "s");
    }
}

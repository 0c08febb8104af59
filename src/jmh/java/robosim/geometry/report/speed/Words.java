package robosim.geometry.report.speed;

import java.util.Locale;
import java.util.OptionalDouble;

/** Figures as a person reads them. */
final class Words {
    static final String NONE = "\u2013";

    private Words() {}

    /** Nanoseconds with three digits, from 1,000 on without any behind the point. */
    static String nanos(OptionalDouble nanos) {
        return nanos.isEmpty() ? NONE : nanos(nanos.getAsDouble());
    }

    static String nanos(double nanos) {
        return nanos < 10 ? format("%.1f", nanos) : format("%,d", Math.round(nanos));
    }

    /** A time in the unit that suits it. */
    static String time(double nanos) {
        if (nanos < 1e3) {
            return nanos(nanos) + " ns";
        }
        return nanos < 1e6
                ? digits(nanos * 1e-3) + " \u00b5s"
                : nanos < 1e9 ? digits(nanos * 1e-6) + " ms" : digits(nanos * 1e-9) + " s";
    }

    /** Two digits at least. */
    static String digits(double value) {
        return value < 10 ? format("%.1f", value) : format("%,d", Math.round(value));
    }

    static String ratio(OptionalDouble ratio) {
        return ratio.isEmpty() ? NONE : ratio(ratio.getAsDouble());
    }

    static String ratio(double ratio) {
        if (ratio > 0 && ratio < 0.095) {
            return "1/" + count(1 / ratio) + " x";
        }
        return (ratio < 10 ? format("%.2f", ratio) : format("%,.1f", ratio)) + " x";
    }

    /** A share in per cent, and never 0 % for what happened. */
    static String percent(double share) {
        double percent = 100 * share;
        if (percent == 0) {
            return "0 %";
        }
        return percent < 0.01
                ? "< 0.01 %"
                : format(percent < 1 ? "%.2f %%" : percent < 99.95 ? "%.1f %%" : "%.0f %%", percent);
    }

    /** A size that may be anything from nothing to much. */
    static String size(double value) {
        if (value == 0) {
            return "0";
        }
        if (value >= 0.01 && value < 1e5) {
            return value < 10 ? format("%.3g", value).replaceFirst("\\.?0+$", "") : format("%,d", Math.round(value));
        }
        return format("%.1e", value).replace("e-0", "e-").replace("e+0", "e").replace("e+", "e");
    }

    static String size(OptionalDouble value) {
        return value.isEmpty() ? NONE : size(value.getAsDouble());
    }

    static String count(double value) {
        return format("%,d", Math.round(value));
    }

    private static String format(String format, Object value) {
        return String.format(Locale.ROOT, format, value);
    }
}

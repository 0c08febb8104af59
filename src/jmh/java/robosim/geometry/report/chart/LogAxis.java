package robosim.geometry.report.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import robosim.geometry.chart.Axis;

/**
 * Powers of ten from one to another, and where it is asked for a strip of its own for zero before them.
 *
 * @param low     exponent of the first power of ten
 * @param high    exponent of the last one, above {@code low}
 * @param hasZero whether zero, which no logarithm knows, has a strip before the first
 * @param label   what is written at an exponent
 */
public record LogAxis(String title, int low, int high, boolean hasZero, IntFunction<String> label) implements Axis {
    private static final double STRIP = 0.12;
    private static final double ZERO = 0.045;
    private static final double ROOM = 1.25;
    private static final int MOST_LABELS = 9;

    /** Refuses an axis without length. */
    public LogAxis {
        if (high <= low) {
            throw new IllegalArgumentException("an axis must have a decade (got: " + low + " to " + high + ")");
        }
    }

    /** Wide enough for all values; zeros among them get a strip. */
    public static LogAxis around(String title, double[] values, IntFunction<String> label) {
        return around(title, values, label, 1);
    }

    /** Wide enough for all values and a little more, so that no marker stands on a border. */
    public static LogAxis roomy(String title, double[] values, IntFunction<String> label) {
        return around(title, values, label, ROOM);
    }

    private static LogAxis around(String title, double[] values, IntFunction<String> label, double room) {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        boolean hasZero = false;
        for (double value : values) {
            hasZero |= value == 0;
            if (value > 0 && value < Double.POSITIVE_INFINITY) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        int low = most == 0 ? 0 : Decades.floor(least / room);
        int high = most == 0 ? 1 : Math.max(low + 1, Decades.ceil(most * room));
        return new LogAxis(title, low, high, hasZero, label);
    }

    @Override
    public double at(double value) {
        if (value <= 0) {
            return hasZero ? ZERO : 0;
        }
        double begin = hasZero ? STRIP : 0;
        double share = (Math.log10(value) - low) / (high - low);
        return begin + (1 - begin) * Math.min(1, Math.max(0, share));
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        if (hasZero) {
            ticks.add(new Tick(ZERO, "0", true));
        }
        int step = (high - low) / MOST_LABELS + 1;
        for (int exponent = low; exponent <= high; exponent++) {
            boolean labelled = Math.floorMod(exponent, step) == 0;
            ticks.add(new Tick(at(Math.pow(10, exponent)), labelled ? label.apply(exponent) : "", labelled));
            for (int digit = 2; digit <= 9 && exponent < high && high - low <= 4; digit++) {
                ticks.add(new Tick(at(digit * Math.pow(10, exponent)), "", false));
            }
        }
        return ticks;
    }

    @Override
    public List<Double> breaks() {
        return hasZero ? List.of(STRIP) : List.of();
    }
}

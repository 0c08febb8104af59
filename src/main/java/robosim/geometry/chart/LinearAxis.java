package robosim.geometry.chart;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import robosim.geometry.check.NumberText;

/**
 * From one value to another, with marks at multiples of a round step.
 *
 * @param high above {@code low}
 */
public record LinearAxis(String title, double low, double high, BigDecimal step) implements Axis {
    private static final int STEPS = 6;

    /** Room beside the values, as a share of their range. */
    private static final double ROOM = 0.06;

    /** From 0 to a round number, long enough for a value above 0. */
    public static LinearAxis upTo(String title, double most) {
        BigDecimal step = round(most / STEPS);
        double end = step.doubleValue() * Math.ceil(most / step.doubleValue());
        return new LinearAxis(title, 0, end, step);
    }

    /** From the least value to the greatest, with a little room at both ends. */
    public static LinearAxis around(String title, double least, double most) {
        double size = most > least ? most - least : Math.max(Math.abs(least), 1);
        double low = least - ROOM * size;
        double high = most + ROOM * size;
        return new LinearAxis(title, low, high, round((high - low) / STEPS));
    }

    /** The next larger of 1, 2 and 5 times a power of ten. */
    private static BigDecimal round(double least) {
        int power = (int) Math.floor(StrictMath.log10(least));
        for (int digit : new int[] {1, 2, 5}) {
            BigDecimal step = BigDecimal.valueOf(digit).scaleByPowerOfTen(power);
            if (step.doubleValue() >= least) {
                return step;
            }
        }
        return BigDecimal.ONE.scaleByPowerOfTen(power + 1);
    }

    @Override
    public double at(double value) {
        return Math.min(1, Math.max(0, (value - low) / (high - low)));
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        double by = step.doubleValue();
        for (long k = (long) Math.ceil(low / by); k * by <= high; k++) {
            BigDecimal value = BigDecimal.valueOf(k).multiply(step);
            boolean isWhole = by >= 1 && by < 1e9;
            String label = isWhole ? String.format(Locale.ROOT, "%,d", value.longValue()) : NumberText.of(value);
            ticks.add(new Tick(at(value.doubleValue()), label, true));
        }
        return ticks;
    }
}

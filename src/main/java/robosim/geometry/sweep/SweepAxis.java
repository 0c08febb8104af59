package robosim.geometry.sweep;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/** One axis of a plot: maps numbers to positions, with ticks at round numbers. */
final class SweepAxis {
    private static final int TICKS = 6;

    private final double low;
    private final double high;
    private final double start;
    private final double end;
    private final BigDecimal step;

    /** An axis over a range, slightly extended, from one position to another. */
    SweepAxis(double low, double high, double start, double end) {
        double size = high > low ? high - low : Math.max(Math.abs(low), 1);
        this.low = low - 0.06 * size;
        this.high = high + 0.06 * size;
        this.start = start;
        this.end = end;
        step = round((this.high - this.low) / TICKS);
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

    /** The position of a number. */
    double at(double number) {
        return start + (number - low) / (high - low) * (end - start);
    }

    List<Double> ticks() {
        List<Double> ticks = new ArrayList<>();
        double by = step.doubleValue();
        for (long k = (long) Math.ceil(low / by); k * by <= high; k++) {
            ticks.add(BigDecimal.valueOf(k).multiply(step).doubleValue());
        }
        return ticks;
    }

    /** The label of a tick, with as many digits as all ticks need. */
    String label(double tick) {
        return BigDecimal.valueOf(Math.round(tick / step.doubleValue()))
                .multiply(step)
                .stripTrailingZeros()
                .toPlainString();
    }
}

package robosim.geometry.report.chart;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * From 0 to somewhat above the greatest value, with a few round marks.
 *
 * @param end the last mark, above 0
 */
public record LinearAxis(String title, double step, double end) implements Axis {
    /** Long enough for a value above 0, with three to six marks. */
    public static LinearAxis upTo(String title, double most) {
        double step = Math.pow(10, Decades.floor(most) - 1);
        for (double factor : new double[] {2, 2.5, 2, 2, 2.5}) {
            if (most / step > 6) {
                step *= factor;
            }
        }
        return new LinearAxis(title, step, step * Math.ceil(most / step));
    }

    @Override
    public double at(double value) {
        return Math.min(1, Math.max(0, value / end));
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        long count = Math.round(end / step);
        for (long k = 0; k <= count; k++) {
            double value = k * step;
            String label = step >= 1
                    ? String.format(Locale.ROOT, "%,d", Math.round(value))
                    : BigDecimal.valueOf(value)
                            .round(new MathContext(6))
                            .stripTrailingZeros()
                            .toPlainString();
            ticks.add(new Tick(at(value), label, true));
        }
        return ticks;
    }
}

package robosim.geometry.report.chart;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import robosim.geometry.chart.Axis;

/**
 * Powers of ten to both sides of zero, which has a column of its own in the middle.
 *
 * @param low  exponent of the least size on either side
 * @param high exponent of the greatest one
 */
public record SignedLogAxis(String title, int low, int high) implements Axis {
    private static final double STRIP = 0.06;
    private static final int MOST_LABELS = 5;

    @Override
    public double at(double value) {
        if (value == 0) {
            return 0.5;
        }
        double share = (Math.log10(Math.abs(value)) - low) / (high - low);
        double away = STRIP / 2 + (0.5 - STRIP / 2) * Math.min(1, Math.max(0, share));
        return value < 0 ? 0.5 - away : 0.5 + away;
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        int step = (high - low) / MOST_LABELS + 1;
        for (int exponent = high; exponent >= low; exponent--) {
            if ((high - exponent) % step == 0) {
                double size = Math.pow(10, exponent);
                ticks.add(new Tick(at(-size), "\u2212" + Decades.plain(exponent), true));
                ticks.add(new Tick(at(size), Decades.plain(exponent), true));
            }
        }
        ticks.add(new Tick(0.5, "0", false));
        ticks.sort(Comparator.comparingDouble(Tick::at));
        return ticks;
    }

    @Override
    public List<Double> breaks() {
        return List.of(0.5 - STRIP / 2, 0.5 + STRIP / 2);
    }
}

package robosim.geometry.report.chart;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Axis;

/**
 * Shares from 0 to 1, stretched towards 1 so that 99 % and 99.99 % can be told apart; 1 itself is the end.
 *
 * @param nines how many nines the last mark before the end has
 */
public record NinesAxis(String title, int nines) implements Axis {
    private static final String[] LABELS = {"0 %", "90 %", "99 %", "99.9 %", "99.99 %", "99.999 %"};

    @Override
    public double at(double share) {
        double width = 1.0 / (nines + 0.7);
        return share >= 1 ? 1 : Math.min(1, Math.max(0, -Math.log10(1 - share)) * width);
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        ticks.add(new Tick(0, LABELS[0], true));
        ticks.add(new Tick(at(0.5), "50 %", true));
        for (int k = 1; k <= nines; k++) {
            ticks.add(new Tick(at(1 - Math.pow(10, -k)), LABELS[k], true));
        }
        ticks.add(new Tick(1, "all", true));
        return ticks;
    }
}

package robosim.geometry.report.chart;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Axis;

/** Shares from 0 to 1 in per cent, evenly, with a little room at both ends so that no marker is cut. */
public record PercentAxis(String title) implements Axis {
    private static final double ROOM = 0.04;

    @Override
    public double at(double share) {
        return ROOM + (1 - 2 * ROOM) * Math.min(1, Math.max(0, share));
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        for (int percent = 0; percent <= 100; percent += 25) {
            ticks.add(new Tick(at(percent / 100.0), percent + " %", true));
        }
        return ticks;
    }
}

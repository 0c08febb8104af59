package robosim.geometry.report.chart;

import java.util.ArrayList;
import java.util.List;
import robosim.geometry.chart.Axis;

/** Names in lines, the first on top: the value of a line is its number. */
public record NamesAxis(String title, List<String> names) implements Axis {
    /** Keeps a copy of the names. */
    public NamesAxis {
        names = List.copyOf(names);
    }

    @Override
    public boolean isScale() {
        return false;
    }

    @Override
    public double at(double line) {
        return 1 - (line + 0.5) / names.size();
    }

    @Override
    public List<Tick> ticks() {
        List<Tick> ticks = new ArrayList<>();
        for (int k = 0; k < names.size(); k++) {
            ticks.add(new Tick(at(k), names.get(k), false));
        }
        return ticks;
    }
}

package robosim.geometry.chart;

import java.util.List;

/** One pair of axes and what is drawn between them. */
public record Panel(String title, Axis x, Axis y, List<Series> series) {
    /** Keeps a copy of the series. */
    public Panel {
        series = List.copyOf(series);
    }
}

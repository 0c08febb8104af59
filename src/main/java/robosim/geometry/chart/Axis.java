package robosim.geometry.chart;

import java.util.List;

/** Where values stand along one side of a plot, from 0 to 1. */
public interface Axis {
    /** A mark on the axis: where, what is written there, and whether a line crosses the plot. */
    record Tick(double at, String label, boolean line) {}

    /** What is measured, and its unit. */
    String title();

    /** Where a value stands; values beyond an end stand at that end. */
    double at(double value);

    /** Marks, in order. */
    List<Tick> ticks();

    /** Whether its marks stand on a line, as those of a scale do, and names do not. */
    default boolean isScale() {
        return true;
    }

    /** Where something other than the scale begins or ends, such as the strip of zeros; may be empty. */
    default List<Double> breaks() {
        return List.of();
    }
}

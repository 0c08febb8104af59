package robosim.geometry.chart;

import java.util.List;

/**
 * What belongs together in a plot.
 *
 * @param name   for the legend; series of one name and look share one line there
 * @param colour number of its colour, see {@link Style}
 * @param line   how its points are joined
 * @param hollow whether its markers are outlines
 */
public record Series(String name, int colour, Marker marker, Line line, boolean hollow, List<Dot> dots) {
    /** How points are joined. */
    public enum Line {
        NONE,
        SOLID,
        DASHED,
        /** No marker, a line alone. */
        BARE,
        /** A bar from the beginning of the axis of X to each point. */
        BARS
    }

    /**
     * A point.
     *
     * @param label  what is written beside it; may be empty
     * @param margin half the length of a bar through it along Y, as of an interval; 0 for none
     */
    public record Dot(double x, double y, String label, double margin) {
        /** Without a bar. */
        public Dot(double x, double y, String label) {
            this(x, y, label, 0);
        }
    }

    /** Keeps a copy of the points. */
    public Series {
        dots = List.copyOf(dots);
    }

    String look() {
        return name + colour + marker + line + hollow;
    }
}

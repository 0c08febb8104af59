package robosim.geometry.viewer.space;

import java.util.Arrays;
import robosim.geometry.viewer.draw.Ink;

/**
 * Something drawn over a picture.
 *
 * @param kind   how its points are drawn
 * @param points X, Y and Z of each, in the world; not to be changed
 * @param seen   for each point whether nothing is in front of it; not to be changed
 * @param ink    its colour
 * @param width  of lines and dots in pixels
 * @param share  how opaque it is where it is seen, from 0 to 1
 */
public record Trace(Kind kind, double[] points, boolean[] seen, Ink ink, double width, double share) {
    /** How the points of a trace are drawn. */
    public enum Kind {
        /** A line from each point to the next. */
        LINE,
        /** Triangles of the first point and each two neighbours of the others. */
        FAN,
        /** A dot at each point. */
        DOTS
    }

    /** A trace that nothing is in front of. */
    static Trace of(Kind kind, double[] points, Ink ink, double width, double share) {
        boolean[] seen = new boolean[points.length / 3];
        Arrays.fill(seen, true);
        return new Trace(kind, points, seen, ink, width, share);
    }

    /** The number of points. */
    public int size() {
        return seen.length;
    }

    Trace seen(boolean[] which) {
        return new Trace(kind, points, which, ink, width, share);
    }
}

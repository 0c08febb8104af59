package robosim.geometry.viewer.space;

import java.util.Arrays;
import robosim.geometry.viewer.draw.Ink;

/** Something drawn over a picture. */
public final class Trace {
    private final Kind kind;
    private final double[] points;
    private final boolean[] seen;
    private final Ink ink;
    private final double width;
    private final double share;

    /** Keeps the arrays, and does not copy them. */
    private Trace(Kind kind, double[] points, boolean[] seen, Ink ink, double width, double share) {
        this.kind = kind;
        this.points = points;
        this.seen = seen;
        this.ink = ink;
        this.width = width;
        this.share = share;
    }

    /** How its points are drawn. */
    public Kind kind() {
        return kind;
    }

    /** X, Y and Z of each point, in the world; its own array, not to be changed. */
    public double[] points() {
        return points;
    }

    /** For each point whether nothing is in front of it; its own array, not to be changed. */
    public boolean[] seen() {
        return seen;
    }

    /** Its colour. */
    public Ink ink() {
        return ink;
    }

    /** Of lines and dots, in pixels. */
    public double width() {
        return width;
    }

    /** How opaque it is where it is seen, from 0 to 1. */
    public double share() {
        return share;
    }

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

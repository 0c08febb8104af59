package robosim.geometry.viewer.draw;

import java.util.List;

/** What the painter draws on; pixels, x to the right and y down. */
public interface Canvas {
    /** Where a text stands from its place. */
    enum Anchor {
        START,
        MIDDLE,
        END
    }

    /** Begins a part of the picture, which has a role and, where it stands for one thing, that thing's name. */
    void open(String role, String name);

    /** Ends the part begun last. */
    void close();

    /** What follows shows only inside this rectangle, until {@link #unclip}. */
    void clip(double x, double y, double width, double height);

    void unclip();

    /** Closed polygons of x, y, x, y ... that are filled as one: what several of them cover is covered once. */
    void polygons(List<double[]> corners, Style style);

    /** An open line of x, y, x, y ... */
    void polyline(double[] corners, Style style);

    void circle(double x, double y, double radius, Style style);

    /**
     * A piece of pie.
     *
     * @param from  degrees from the page's right, counter-clockwise as seen
     * @param sweep degrees counter-clockwise, above 0 and below 360
     */
    void sector(double x, double y, double radius, double from, double sweep, Style style);

    /** The outer line of a piece of pie. */
    void arc(double x, double y, double radius, double from, double sweep, Style style);

    /** A line of text on its base line, with a rim of paper around it. */
    void text(double x, double y, String text, Anchor anchor, double size, Ink ink);

    /** A rectangle. */
    default void rectangle(double x, double y, double width, double height, Style style) {
        polygons(List.of(new double[] {x, y, x + width, y, x + width, y + height, x, y + height}), style);
    }

    /** A straight line. */
    default void line(double x1, double y1, double x2, double y2, Style style) {
        polyline(new double[] {x1, y1, x2, y2}, style);
    }
}

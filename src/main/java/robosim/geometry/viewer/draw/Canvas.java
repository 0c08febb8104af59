package robosim.geometry.viewer.draw;

import java.util.List;

/** A surface that the painter draws on; in pixels, x to the right and y down. */
public interface Canvas {
    /** How a text is placed relative to its point. */
    enum Anchor {
        START,
        MIDDLE,
        END
    }

    /** Begins a part of the picture, with a role and, if it represents one object, that object's name. */
    void open(String role, String name);

    /** Ends the part begun last. */
    void close();

    /** Clips what follows to this rectangle, until {@link #unclip}. */
    void clip(double x, double y, double width, double height);

    void unclip();

    /** Closed polygons of x, y, x, y ... that are filled as their union. */
    void polygons(List<double[]> corners, Style style);

    /** An open line of x, y, x, y ... */
    void polyline(double[] corners, Style style);

    void circle(double x, double y, double radius, Style style);

    /**
     * A circular sector.
     *
     * @param from  degrees from the page's right, counter-clockwise as seen
     * @param sweep degrees counter-clockwise, above 0 and below 360
     */
    void sector(double x, double y, double radius, double from, double sweep, Style style);

    /** The arc of a circular sector. */
    void arc(double x, double y, double radius, double from, double sweep, Style style);

    /** A line of text on its base line, with an outline in the background colour. */
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

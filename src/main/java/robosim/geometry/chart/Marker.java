package robosim.geometry.chart;

import java.util.Locale;

/** The shape of a point, so that nobody needs to tell colours apart. */
public enum Marker {
    CIRCLE,
    SQUARE,
    TRIANGLE,
    DIAMOND,
    CROSS,
    DOWN,
    PLUS,
    BAR;

    /** Draws it about a place, in a style class. */
    String draw(double x, double y, double r, String style) {
        String d = switch (this) {
            case CIRCLE ->
                path(
                        "M%1$.1f %2$.1fm-%3$.1f 0a%3$.1f %3$.1f 0 1 0 %4$.1f 0a%3$.1f %3$.1f 0 1 0 -%4$.1f 0z",
                        x, y, r, 2 * r);
            case SQUARE -> path("M%1$.1f %2$.1fm-%3$.1f -%3$.1fh%4$.1fv%4$.1fh-%4$.1fz", x, y, 0.9 * r, 1.8 * r);
            case TRIANGLE -> path("M%1$.1f %2$.1fm0 -%3$.1fl%3$.1f %4$.1fh-%5$.1fz", x, y, 1.15 * r, 2 * r, 2.3 * r);
            case DOWN -> path("M%1$.1f %2$.1fm0 %3$.1fl%3$.1f -%4$.1fh-%5$.1fz", x, y, 1.15 * r, 2 * r, 2.3 * r);
            case DIAMOND ->
                path("M%1$.1f %2$.1fm0 -%3$.1fl%3$.1f %3$.1fl-%3$.1f %3$.1fl-%3$.1f -%3$.1fz", x, y, 1.25 * r);
            case CROSS ->
                path("M%1$.1f %2$.1fm-%3$.1f -%3$.1fl%4$.1f %4$.1fm0 -%4$.1fl-%4$.1f %4$.1f", x, y, 0.9 * r, 1.8 * r);
            case PLUS -> path("M%1$.1f %2$.1fm-%3$.1f 0h%4$.1fm-%3$.1f -%3$.1fv%4$.1f", x, y, 1.2 * r, 2.4 * r);
            case BAR -> path("M%1$.1f %2$.1fm0 -%3$.1fv%4$.1f", x, y, 1.5 * r, 3 * r);
        };
        return "<path class=\"" + style + "\" d=\"" + d + "\"/>\n";
    }

    private static String path(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}

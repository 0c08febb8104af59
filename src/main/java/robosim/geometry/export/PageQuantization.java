package robosim.geometry.export;

import robosim.geometry.model.Bounds;
import robosim.geometry.model.Point;

/**
 * The numbers of a page: its own unit and origin, and the steps to which places, angles and distances are rounded.
 *
 * <p>A page's unit is a power of two of which the longest side of what it shows takes more than 16 and at most 32, so that
 * single precision and the settings of the camera suit a world of any size. Places are rounded to 2<sup>-13</sup> of that unit.
 * So a coordinate is off by at most 2<sup>-14</sup> units, less than 1/262,144 of the longest side; an angle by at most half of
 * 1/65,536 of a turn, 0.0028 degrees; a measured distance by less than 1/65,536 of the longest side.
 */
final class PageQuantization {
    /** Steps of a coordinate in a page's unit. */
    static final int PLACE = 1 << 13;

    /** Steps of a measured distance. */
    static final int RANGE = 1 << 11;

    /** Steps of a full turn. */
    static final int TURN = 1 << 16;

    /** Steps of a component of a quaternion. */
    static final int SPIN = 1 << 15;

    /** Farther coordinates, in steps, are not shown where they are. */
    private static final double FARTHEST = 1L << 50;

    private final Point origin;
    private final int exponent;
    private final double unit;

    /** For what lies around these bounds. */
    PageQuantization(Bounds bounds) {
        origin = new Point(bounds.middleX(), bounds.middleY(), bounds.middleZ());
        double longest = Math.max(bounds.width(), Math.max(bounds.height(), bounds.length()));
        int whole = Math.max(-900, Math.getExponent(longest));
        exponent = longest > Math.scalb(1.0, whole) ? whole - 4 : whole - 5;
        unit = Math.scalb(1.0, exponent);
    }

    Point origin() {
        return origin;
    }

    /** The page's unit is two to this power. */
    int exponent() {
        return exponent;
    }

    /** A length in the page's unit. */
    double length(double length) {
        return length / unit;
    }

    double x(Point place) {
        return (place.x() - origin.x()) / unit;
    }

    double y(Point place) {
        return (place.y() - origin.y()) / unit;
    }

    double z(Point place) {
        return (place.z() - origin.z()) / unit;
    }

    /** A coordinate in steps. */
    static long steps(double coordinate) {
        return round(coordinate * PLACE);
    }

    /** A measured distance in steps. */
    long range(double distance) {
        return round(distance / unit * RANGE);
    }

    /** An angle in degrees in steps of a turn, from 0 to below {@link #TURN}. */
    static int turn(double degrees) {
        return Math.floorMod(round(degrees % 360 * (TURN / 360.0)), TURN);
    }

    /** The nearest whole number; JavaScript rounds in this way too. */
    static long round(double value) {
        return (long) Math.floor(Math.max(-FARTHEST, Math.min(FARTHEST, value)) + 0.5);
    }

    /** The cosine of an angle in steps of a turn. */
    static double cos(int turn) {
        return sin(turn + TURN / 4);
    }

    /**
     * The sine of an angle in steps of a turn, to 1e-11: by sums and products in an order that is JavaScript's too, so that
     * both have the same bits.
     */
    static double sin(int turn) {
        int step = Math.floorMod(turn, TURN);
        double sign = 1;
        if (step >= TURN / 2) {
            step -= TURN / 2;
            sign = -1;
        }
        if (step > TURN / 4) {
            step = TURN / 2 - step;
        }
        double a = step * 9.587379924285257e-5; // two pi over 65,536
        double s = a * a;
        double t = -1.0 / 39916800 + s * (1.0 / 6227020800.0 + s * (-1.0 / 1307674368000.0));
        return sign * (a * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * t))))));
    }
}

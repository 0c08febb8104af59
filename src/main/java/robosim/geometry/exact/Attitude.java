package robosim.geometry.exact;

/**
 * The attitude of an object, stored in {@link #STRIDE} consecutive doubles of an array: the nine numbers of a rotation
 * (row-major, its columns are the object's own axes), then a heading in degrees as a sum and its rounding error.
 *
 * <p>While the object's own Y is the world's, the rotation is recomputed from the heading after every turn: the heading
 * stored is within {@link Degrees#ADDITION_ERROR} degree per turn of the exact sum (less than 1e-23 degree after
 * 10<sup>6</sup> turns), the one returned is that to within half an ulp (1.5e-14 degree), and the rotation is as
 * accurate after 10<sup>7</sup> turns as after one. A tipped attitude is composed turn by turn and re-orthonormalized
 * each time: it always remains a rotation to {@link Rotations#ORTHONORMALITY}, and its direction is off by at most
 * {@link Rotations#TURN_ERROR} radian per turn (4.5e-8 degree after 10<sup>6</sup>). Only quarter turns, which are
 * exact, can make a tipped attitude upright again.
 */
public final class Attitude {
    /** Number of doubles that store one attitude. */
    public static final int STRIDE = 11;

    public static final int HEADING = 9;

    private Attitude() {}

    /** A new array with one attitude: upright, facing +X. */
    public static double[] identity() {
        double[] entry = new double[STRIDE];
        entry[0] = 1;
        entry[4] = 1;
        entry[8] = 1;
        return entry;
    }

    /** Whether the nine numbers from {@code at} on are a rotation: right-handed and orthonormal to 1e-9. */
    public static boolean isRotation(double[] column, int at) {
        return Rotations.isOrthonormal(column, at);
    }

    /** Whether nine numbers are a rotation: right-handed and orthonormal to 1e-9. */
    public static boolean isRotation(double[] rotation) {
        return Rotations.isOrthonormal(rotation, 0);
    }

    /** Sets an upright attitude with a heading of {@code hi + lo} degrees. */
    public static void setHeading(double[] column, int at, double hi, double lo) {
        column[at + HEADING] = 0;
        column[at + HEADING + 1] = 0;
        Degrees.add(column, at + HEADING, hi);
        Degrees.add(column, at + HEADING, lo);
        Rotations.yaw(column[at + HEADING], column[at + HEADING + 1], column, at);
    }

    /** Sets the rotation, kept as given. */
    public static void orient(double[] column, int at, double[] rotation) {
        for (int k = 0; k < 9; k++) {
            column[at + k] = rotation[k] + 0.0; // no -0.0
        }
        readHeading(column, at);
    }

    /** Whether the own Y is exactly the world's. */
    public static boolean isUpright(double[] column, int at) {
        return column[at + 4] == 1
                && column[at + 1] == 0
                && column[at + 3] == 0
                && column[at + 5] == 0
                && column[at + 7] == 0;
    }

    /** Degrees about the vertical from the world's X to forward, above -180 and up to 180. */
    public static double heading(double[] column, int at) {
        return column[at + HEADING];
    }

    /** Turns by a number of degrees about the world's vertical. */
    public static void turnVertically(double[] column, int at, double degrees) {
        if (isUpright(column, at)) {
            turn(column, at, 0, degrees);
        } else if (degrees != 0) {
            Rotations.turnVertically(column, at, degrees);
            readHeading(column, at);
        }
    }

    /** Turns by a number of degrees about the world's X. */
    public static void turnAboutX(double[] column, int at, double degrees) {
        if (degrees != 0) {
            Rotations.turnWorldX(column, at, degrees);
            readHeading(column, at);
        }
    }

    /** Turns by {@code ry} degrees about the own Y, then by {@code rx} about the own X. */
    public static void turn(double[] column, int at, double rx, double ry) {
        if (ry != 0) {
            if (isUpright(column, at)) {
                Degrees.add(column, at + HEADING, ry);
                Rotations.yaw(column[at + HEADING], column[at + HEADING + 1], column, at);
            } else {
                Rotations.turnOwnY(column, at, ry);
                readHeading(column, at);
            }
        }
        if (rx != 0) {
            Rotations.turnOwnX(column, at, rx);
            readHeading(column, at);
        }
    }

    private static void readHeading(double[] column, int at) {
        column[at + HEADING] = Degrees.headingOf(column[at], column[at + 6]);
        column[at + HEADING + 1] = 0;
    }
}

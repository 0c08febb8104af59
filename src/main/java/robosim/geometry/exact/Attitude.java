package robosim.geometry.exact;

/**
 * How something is turned, in a flat column of {@link #STRIDE} doubles: the nine numbers of a rotation (row-major, its
 * columns are the own axes), then a heading in degrees as a sum and the rounding that it lost.
 *
 * <p>While the own Y is the world's, the rotation is made from the heading, from scratch, after every turn: the heading
 * kept is within {@link Degrees#ADDITION_ERROR} degree a turn of the exact sum (less than 1e-23 degree after 10<sup>6</sup>
 * turns), the one told is that to within half an ulp (1.5e-14 degree), and the rotation is as good after 10<sup>7</sup>
 * turns as after one. What is tipped is composed turn by turn and made orthonormal again each time: it stays a rotation to
 * {@link Rotations#ORTHONORMALITY} for ever, and its direction is off by at most {@link Rotations#TURN_ERROR} radian a turn
 * (4.5e-8 degree after 10<sup>6</sup>). Only quarter turns, which are exact, make what is tipped upright again.
 */
public final class Attitude {
    /** Doubles in a column's entry. */
    public static final int STRIDE = 11;

    private static final int HEADING = 9;

    private Attitude() {}

    /** A fresh entry: upright, facing +X. */
    public static double[] identity() {
        double[] entry = new double[STRIDE];
        entry[0] = 1;
        entry[4] = 1;
        entry[8] = 1;
        return entry;
    }

    /** Whether the nine numbers from there on are a rotation: right-handed and orthonormal to 1e-9. */
    public static boolean isRotation(double[] column, int at) {
        return Rotations.isOrthonormal(column, at);
    }

    /** Whether nine numbers are a rotation: right-handed and orthonormal to 1e-9. */
    public static boolean isRotation(double[] rotation) {
        return Rotations.isOrthonormal(rotation, 0);
    }

    /** Makes the entry upright with a heading of {@code hi + lo} degrees. */
    public static void setHeading(double[] column, int at, double hi, double lo) {
        column[at + HEADING] = 0;
        column[at + HEADING + 1] = 0;
        Degrees.add(column, at + HEADING, hi);
        Degrees.add(column, at + HEADING, lo);
        Rotations.yaw(column[at + HEADING], column[at + HEADING + 1], column, at);
    }

    /** Takes a rotation as it is given. */
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

    /** Turns by some degrees about the world's vertical. */
    public static void turnVertically(double[] column, int at, double degrees) {
        if (isUpright(column, at)) {
            turn(column, at, 0, degrees);
        } else if (degrees != 0) {
            Rotations.turnVertically(column, at, degrees);
            readHeading(column, at);
        }
    }

    /** Turns by some degrees about the world's X. */
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

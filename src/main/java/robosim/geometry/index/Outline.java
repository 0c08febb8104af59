package robosim.geometry.index;

/**
 * What a column of rows tells a {@link QuadTree} about each of its objects: a rectangle on the XZ plane that encloses it,
 * anywhere and at any heading. Row id has {@link #STRIDE} doubles; those not named here are the owner's.
 */
public final class Outline {
    /** Doubles in a row. */
    public static final int STRIDE = 8;

    /** The centre. */
    public static final int X = 0;

    public static final int Z = 2;

    /** Half of its size along its own axes, (cos, -sin) and (sin, cos). */
    public static final int HALF_X = 3;

    public static final int HALF_Z = 5;

    /** Cosine and sine of its heading. */
    public static final int COS = 6;

    public static final int SIN = 7;

    /** Where the first row begins: behind an array's head, so that a row of a large array is one line of a cache. */
    private static final int START = 6;

    private Outline() {}

    /** Where the row of an object begins. */
    public static int at(int id) {
        return START + STRIDE * id;
    }

    /** How long an array of so many rows is. */
    public static int length(int rows) {
        return START + STRIDE * rows;
    }

    /** Makes a row that of a box, to within the rounding that a query allows for. */
    public static void write(double[] rows, int id, double minX, double minZ, double maxX, double maxZ) {
        int at = at(id);
        rows[at + X] = minX / 2 + maxX / 2;
        rows[at + Z] = minZ / 2 + maxZ / 2;
        rows[at + HALF_X] = maxX / 2 - minX / 2;
        rows[at + HALF_Z] = maxZ / 2 - minZ / 2;
        rows[at + COS] = 1;
        rows[at + SIN] = 0;
    }
}

package robosim.geometry.index.tiles;

/**
 * For each object of a {@code QuadTree} a rectangle in the XZ plane that encloses it, at any position and heading,
 * stored as one row of an array. The row of an id has {@link #STRIDE} doubles; those not named here are at the owner's
 * disposal.
 */
public final class OrientedRectangle {
    /** Number of doubles in a row. */
    public static final int STRIDE = 8;

    /** The centre. */
    public static final int X = 0;

    public static final int Z = 2;

    /** Half of the rectangle's size along its own axes, (cos, -sin) and (sin, cos). */
    public static final int HALF_X = 3;

    public static final int HALF_Z = 5;

    /** Cosine and sine of its heading. */
    public static final int COS = 6;

    public static final int SIN = 7;

    /** The id of a row before all others, whose rectangle is nowhere: neither a box nor a ray meets it. */
    static final int NOWHERE = Tiles.NONE;

    /**
     * Where the first row begins: chosen with the array's header in mind, so that a row of a large array is one cache
     * line.
     */
    private static final int START = 6 + STRIDE;

    /** A half size so far below 0 that its sum with any number of a world is negative. */
    private static final double SHORT_OF_ALL = -0x1p1000;

    private OrientedRectangle() {}

    /** The index at which an object's row begins. */
    public static int at(int id) {
        return START + STRIDE * id;
    }

    /** The length of an array with a given number of rows. */
    public static int length(int rows) {
        return START + STRIDE * rows;
    }

    /** An array with room for a given number of rows and of further numbers. */
    public static double[] rows(int count, int more) {
        double[] rows = new double[length(count) + more];
        int at = at(NOWHERE);
        rows[at + HALF_X] = SHORT_OF_ALL;
        rows[at + HALF_Z] = SHORT_OF_ALL;
        rows[at + COS] = 1;
        return rows;
    }

    /** Whether a row's rectangle and a given one, already widened by the rounding errors, may meet. */
    static boolean mayTouch(double[] rows, int id, double x, double z, double wide, double deep) {
        int at = at(id);
        double halfX = rows[at + HALF_X];
        double halfZ = rows[at + HALF_Z];
        double cos = Math.abs(rows[at + COS]);
        double sin = Math.abs(rows[at + SIN]);
        double gapX = Math.fma(halfX, cos, Math.fma(halfZ, sin, wide)) - Math.abs(rows[at + X] - x);
        double gapZ = Math.fma(halfX, sin, Math.fma(halfZ, cos, deep)) - Math.abs(rows[at + Z] - z);
        // Two comparisons in one: a negative difference is a gap.
        return (Double.doubleToRawLongBits(gapX) | Double.doubleToRawLongBits(gapZ)) >= 0;
    }

    /** Sets a row to a box, to within the rounding that a query allows for. */
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

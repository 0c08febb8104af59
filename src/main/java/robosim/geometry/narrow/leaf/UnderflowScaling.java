package robosim.geometry.narrow.leaf;

/**
 * Scales leaves that are so small, and so near the origin, that products of their coordinates underflow, by a power of
 * two, which changes no bit of a distance. Verdicts do not need this, since they fall back on exact arithmetic.
 *
 * <p>Kernels multiply up to four lengths. If some coordinate or size is {@link #SMALL} or more, its ulp to the fourth
 * power is above {@code 2^-1075}, and the error of underflow is less than any bound stated in ulp of the largest
 * coordinate.
 */
public final class UnderflowScaling {
    /** A query is scaled if all its coordinates and sizes are below this; distances below this are recomputed. */
    public static final double SMALL = 0x1p-200;

    public final double[] a = new double[Leaf.STRIDE];
    public final double[] b = new double[Leaf.STRIDE];

    /** The binary logarithm of the scale factor. */
    private int power;

    /**
     * Scales a leaf up if it is small.
     *
     * @param start the largest coordinate of the other input of the query
     */
    public boolean take(double start, LeafKind kind, double[] row, int at) {
        return take(Math.max(start, extent(kind, row, at))) && copy(kind, row, at, a);
    }

    /** Scales two leaves up if both are small. */
    public boolean take(LeafKind kindA, double[] rowA, int i, LeafKind kindB, double[] rowB, int j) {
        return take(0, kindA, rowA, i, kindB, rowB, j);
    }

    /** Scales two leaves up if both and the other input, {@code more}, are small. */
    public boolean take(double more, LeafKind kindA, double[] rowA, int i, LeafKind kindB, double[] rowB, int j) {
        return take(Math.max(more, Math.max(extent(kindA, rowA, i), extent(kindB, rowB, j))))
                && copy(kindA, rowA, i, a)
                && copy(kindB, rowB, j, b);
    }

    /** As {@link #take(double, LeafKind, double[], int, LeafKind, double[], int)}, where heights do not count: there are none then. */
    public boolean takeLevel(double more, LeafKind kindA, double[] rowA, int i, LeafKind kindB, double[] rowB, int j) {
        level(kindA, rowA, i, a);
        level(kindB, rowB, j, b);
        return take(more, kindA, a, 0, kindB, b, 0);
    }

    private static void level(LeafKind kind, double[] row, int at, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        switch (kind) {
            case PRISM -> {
                out[8] = 0;
                out[9] = 0;
            }
            case TRIANGLE -> {
                out[1] = 0;
                out[4] = 0;
                out[7] = 0;
            }
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> {
                out[1] = 0;
                out[4] = 0;
            }
            case SPHERE, BOX, CYLINDER, CAPSULE ->
                out[1] = 0; // a tilted leaf's size along its axis affects its projection
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        }
    }

    private boolean take(double largest) {
        power = -Math.getExponent(largest);
        return largest < SMALL && largest > 0;
    }

    private boolean copy(LeafKind kind, double[] row, int at, double[] out) {
        System.arraycopy(row, at, out, 0, Leaf.STRIDE);
        for (int k = 0; k < kind.lengths(); k++) {
            out[k] = up(out[k]);
        }
        return true;
    }

    public double up(double length) {
        return scale(length, power);
    }

    public double down(double length) {
        return scale(length, -power);
    }

    /** In two steps, because the factor itself may not be a double. */
    private static double scale(double value, int power) {
        return Math.scalb(Math.scalb(value, power / 2), power - power / 2);
    }

    private static double extent(LeafKind kind, double[] row, int at) {
        double largest = 0;
        for (int k = 0; k < kind.lengths(); k++) {
            largest = Math.max(largest, Math.abs(row[at + k]));
        }
        return largest;
    }
}

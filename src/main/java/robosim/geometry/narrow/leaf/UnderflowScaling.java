package robosim.geometry.narrow.leaf;

import robosim.geometry.model.Dimension;

/**
 * Scales queries that are so small, and so near the origin, that products of their coordinates underflow, by a power of
 * two, which changes no bit of a distance. Every query about a convex leaf whose answer is a number passes through here,
 * before its kernel computes anything (fast paths of beams trust no small distance): a product that underflowed may make a hit of a miss, not only a distance wrong.
 *
 * <p>Kernels multiply up to six lengths, and those of an oval a factor of 2<sup>-101</sup> more: the rounding error of the
 * product of three, times the oval's least half axis, which is an error of rounding itself. If some coordinate or size is
 * {@link #SMALL} or more, that is above {@code 2^-875}, and twice as many digits of it are above {@code 2^-1000}.
 */
public final class UnderflowScaling {
    /** A query is scaled if all its coordinates and sizes are below this. */
    public static final double SMALL = 0x1p-128;

    /** The leaves scaled up. */
    public final Leaf first = new Leaf();

    public final Leaf second = new Leaf();

    /** The numbers of the first one. */
    public final double[] a = first.row;

    private final PivotTurn scaled = new PivotTurn();

    /** The binary logarithm of the scale factor. */
    private int power;

    /**
     * Scales a leaf up if it and the other input are small; heights do not count in PLANAR, and become 0.
     *
     * @param more the largest coordinate of the other input of the query
     */
    public boolean take(Dimension dimension, double more, LeafKind kind, double[] row, int at) {
        return isSmall(more, row, at) && takeAll(dimension, more, kind, row, at);
    }

    private boolean takeAll(Dimension dimension, double more, LeafKind kind, double[] row, int at) {
        int heights = heights(dimension, kind);
        if (!take(extent(more, kind, row, at, heights))) {
            return false;
        }
        copy(kind, row, at, heights, first);
        return true;
    }

    /** Scales two leaves up if both are small. */
    public boolean take(Dimension dimension, Leaf one, Leaf two) {
        return take(dimension, 0, one, two);
    }

    /** Scales two leaves up if both and the other input, {@code more}, are small. */
    public boolean take(Dimension dimension, double more, Leaf one, Leaf two) {
        return isSmall(more, one.row, one.at) && isSmall(more, two.row, two.at) && takeAll(dimension, more, one, two);
    }

    /** Whether the first length of a row, an x in all kinds, is small; mostly it is not, and no other is looked at. */
    private static boolean isSmall(double more, double[] row, int at) {
        return more < SMALL && Math.abs(row[at]) < SMALL;
    }

    private boolean takeAll(Dimension dimension, double more, Leaf one, Leaf two) {
        int heightsOne = heights(dimension, one.kind);
        int heightsTwo = heights(dimension, two.kind);
        double extent = extent(more, one.kind, one.row, one.at, heightsOne);
        if (!take(extent(extent, two.kind, two.row, two.at, heightsTwo))) {
            return false;
        }
        copy(one.kind, one.row, one.at, heightsOne, first);
        copy(two.kind, two.row, two.at, heightsTwo, second);
        return true;
    }

    /** Which numbers of a row are heights that do not count, one bit each. */
    private static int heights(Dimension dimension, LeafKind kind) {
        if (dimension == Dimension.SPATIAL) {
            return 0;
        }
        return switch (kind) {
            case PRISM -> 1 << 8 | 1 << 9;
            case TRIANGLE -> 1 << 1 | 1 << 4 | 1 << 7;
            case UPRIGHT_BOX, UPRIGHT_CYLINDER, UPRIGHT_CAPSULE -> 1 << 1 | 1 << 4;
            case SPHERE, BOX, CYLINDER, CAPSULE -> 1 << 1; // a tilted leaf's size along its axis affects its projection
            case MESH, SOLID_MESH, GRID -> throw kind.refused();
        };
    }

    private boolean take(double largest) {
        if (!(largest < SMALL && largest > 0)) {
            return false;
        }
        power = -Math.getExponent(largest);
        return true;
    }

    private void copy(LeafKind kind, double[] row, int at, int heights, Leaf out) {
        out.copy(kind, row, at);
        for (int k = 0; k < kind.lengths(); k++) {
            out.row[k] = (heights >> k & 1) == 0 ? up(out.row[k]) : 0;
        }
    }

    public double up(double length) {
        return scale(length, power);
    }

    /** A turn with its pivot scaled up, valid until the next one. */
    public PivotTurn up(PivotTurn turn) {
        return scaled.about(up(turn.px), up(turn.py), up(turn.pz)).by(turn.wx, turn.wy, turn.wz, turn.degrees);
    }

    public double down(double length) {
        return scale(length, -power);
    }

    /** The same, rounded up where it is a subnormal number. */
    public double ceiling(double length) {
        double rounded = down(length);
        return up(rounded) < length ? Math.nextUp(rounded) : rounded;
    }

    /** In two steps, because the factor itself may not be a double. */
    private static double scale(double value, int power) {
        return Math.scalb(Math.scalb(value, power / 2), power - power / 2);
    }

    /** The largest of a number and the lengths of a leaf, or one of them that is not small. */
    private static double extent(double more, LeafKind kind, double[] row, int at, int heights) {
        double largest = more;
        for (int k = 0; k < kind.lengths() && largest < SMALL; k++) {
            if ((heights >> k & 1) == 0) {
                largest = Math.max(largest, Math.abs(row[at + k]));
            }
        }
        return largest;
    }
}

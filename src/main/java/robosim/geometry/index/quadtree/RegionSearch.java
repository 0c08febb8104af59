package robosim.geometry.index.quadtree;

import robosim.geometry.exact.BeamAxis;

/**
 * Searches a {@link RegionTree} around a point, or in a sector of the plane, in the order of how far boxes are, or less: nearest
 * first.
 *
 * <p>A box begins in a direction of the axes at a line, which the sector reaches at a distance that is its height times a
 * factor of the sector: four directions give four lower bounds. And no point of the sector is beyond one of its sides.
 */
public final class RegionSearch {
    /**
     * The share of the coordinates by which boxes are widened, and that is added to the sines of the sector: more than the
     * roundings, and more than what a certified shape is taken larger by.
     */
    private static final double PAD = 0x1p-40;

    /** Where the sector goes along an axis by less than this share of its length, this stands for the share. */
    private static final double FLATTEST = 0x1p-20;

    /** The factor for what the sector goes away from, so that all of it is too far. */
    private static final double NEVER = 0x1p60;

    /** No two points within coordinates are farther apart than this many times the greatest. */
    private static final double ACROSS = 4;

    /** More than any entry. */
    private static final long MISSED = Long.MAX_VALUE;

    /** Four roundings: of a difference, of two sums of squares, and of a root. */
    private static final double DOWN = 1 - 0x1.8p-51;

    /** Regions and, below 0, objects, by the upper halves of the bits of doubles of at least 0, which sort like the doubles. */
    private final LongHeap queue = new LongHeap();

    private long visited;
    private double farthest;
    private boolean isAround;

    /** The last object, and by how much its box is away. */
    private long entry;

    private double fromX;
    private double fromZ;

    // By axis and direction: what gives the distance of a line that a box begins at, times the line's coordinate, and
    // added.
    private double upX;
    private double atUpX;
    private double downX;
    private double atDownX;
    private double upZ;
    private double atUpZ;
    private double downZ;
    private double atDownZ;

    // The outward normals of the sides, for the low and for the high coordinates of a box: one of two is 0.
    private double leftLowX;
    private double leftHighX;
    private double leftLowZ;
    private double leftHighZ;
    private double atLeft;
    private double rightLowX;
    private double rightHighX;
    private double rightLowZ;
    private double rightHighZ;
    private double atRight;

    public long visited() {
        return visited;
    }

    /** A lower bound, to some 2^-20 of it, of the distance of the last object. */
    public double entry() {
        return Double.longBitsToDouble(entry >>> Integer.SIZE << Integer.SIZE);
    }

    /** Starts a search around a point, in the whole plane. */
    public void start(RegionTree tree, double x, double z) {
        if (!Double.isFinite(x) || !Double.isFinite(z)) {
            throw new IllegalArgumentException("point must be finite (got: " + x + ", " + z + ")");
        }
        isAround = true;
        fromX = x;
        fromZ = z;
        farthest = Double.MAX_VALUE;
        start(tree);
    }

    /**
     * Starts a search in the sector about a level beam.
     *
     * @param most at least the greatest magnitude of any coordinate of a box
     */
    public void start(RegionTree tree, BeamAxis beam, double most) {
        double ox = beam.ox;
        double oz = beam.oz;
        double ux = beam.ux();
        double uz = beam.uz();
        double cos = beam.cos;
        double sin = beam.sin;
        double reach = Math.max(most, Math.max(Math.abs(ox), Math.abs(oz)));
        double pad = PAD * reach + Double.MIN_NORMAL;
        isAround = false;
        farthest = ACROSS * reach + Double.MIN_NORMAL;
        upX = factor(ux, cos, sin);
        atUpX = (-ox - pad) * upX;
        downX = -factor(-ux, cos, sin);
        atDownX = (pad - ox) * downX;
        upZ = factor(uz, cos, sin);
        atUpZ = (-oz - pad) * upZ;
        downZ = -factor(-uz, cos, sin);
        atDownZ = (pad - oz) * downZ;
        double x = -sin * ux - cos * uz;
        double z = cos * ux - sin * uz;
        leftLowX = Math.max(x, 0);
        leftHighX = Math.min(x, 0);
        leftLowZ = Math.max(z, 0);
        leftHighZ = Math.min(z, 0);
        atLeft = -(x * ox + z * oz) - pad;
        x = cos * uz - sin * ux;
        z = -sin * uz - cos * ux;
        rightLowX = Math.max(x, 0);
        rightHighX = Math.min(x, 0);
        rightLowZ = Math.max(z, 0);
        rightHighZ = Math.min(z, 0);
        atRight = -(x * ox + z * oz) - pad;
        start(tree);
    }

    private void start(RegionTree tree) {
        queue.clear();
        entry = 0;
        if (tree.regions.links[0] != Regions.EMPTY) {
            double[] b = tree.regions.bounds;
            queue.push(entry(key(b[0], b[1], b[2], b[3]), 0));
        }
    }

    /** The distance at which a sector reaches a line across an axis, of which its own axis has a share, per height. */
    private static double factor(double share, double cos, double sin) {
        double most = share >= cos ? 1 : cos * share + sin * Math.sqrt(Math.max(0, (1 - share) * (1 + share)));
        return most >= FLATTEST ? 1 / (most + PAD) : most > -FLATTEST ? 1 / (2 * FLATTEST) : NEVER;
    }

    /** The next object within the limit, or -1. The limit may shrink from call to call. */
    public int next(RegionTree tree, double[] boxes, double limit) {
        int within = upper(Math.min(limit, farthest));
        long nearest = MISSED;
        while (true) {
            if (nearest == MISSED) {
                if (queue.isEmpty() || (int) (queue.least() >>> Integer.SIZE) > within) {
                    return -1;
                }
                nearest = queue.pop();
            }
            int item = (int) nearest;
            entry = nearest;
            if (item < 0) {
                return ~item;
            }
            visited++;
            int link = tree.regions.links[item];
            if (link < 0) {
                int id = RegionTree.first(link);
                if (link == ~id) {
                    return id; // the region's bounds are its box
                }
                pushAll(tree, boxes, id, within);
                nearest = MISSED;
            } else {
                nearest = open(tree.regions.bounds, link, within);
            }
            if (nearest != MISSED && !queue.isEmpty() && nearest > queue.least()) {
                queue.push(nearest);
                nearest = queue.pop();
            }
        }
    }

    /** Takes four quarters in, but for the nearest, which it returns. */
    private long open(double[] bounds, int first, int within) {
        long nearest = MISSED;
        for (int quarter = first; quarter < first + 4; quarter++) {
            int at = 4 * quarter;
            int key = key(bounds[at], bounds[at + 1], bounds[at + 2], bounds[at + 3]);
            if (key <= within) {
                long entry = entry(key, quarter);
                if (nearest != MISSED) {
                    queue.push(Math.max(nearest, entry));
                }
                nearest = Math.min(nearest, entry);
            }
        }
        return nearest;
    }

    private void pushAll(RegionTree tree, double[] boxes, int first, int within) {
        for (int id = first; id != Regions.NONE; id = tree.next[id]) {
            int at = 6 * id;
            int key = key(boxes[at], boxes[at + 2], boxes[at + 3], boxes[at + 5]);
            if (key <= within) {
                queue.push(entry(key, ~id));
            }
        }
    }

    private static long entry(int key, int item) {
        return (long) key << Integer.SIZE | (item & 0xffffffffL);
    }

    private int key(double minX, double minZ, double maxX, double maxZ) {
        return isAround ? around(minX, minZ, maxX, maxZ) : inSector(minX, minZ, maxX, maxZ);
    }

    /** A lower bound of how far a box is from the point. */
    private int around(double minX, double minZ, double maxX, double maxZ) {
        double dx = Math.max(0, Math.max(minX - fromX, fromX - maxX));
        double dz = Math.max(0, Math.max(minZ - fromZ, fromZ - maxZ));
        double square = dx * dx + dz * dz;
        // If squares lose bits or overflow, the longer leg is used as the lower bound.
        double distance = square > 0x1p-960 && square < 0x1p1000 ? Math.sqrt(square) : Math.max(dx, dz);
        return upper(Math.max(0, distance * DOWN - Double.MIN_VALUE));
    }

    /** A lower bound of how far a box is within the sector; more than that of any number where it is beyond a side. */
    private int inSector(double minX, double minZ, double maxX, double maxZ) {
        int x = Math.max(upper(minX * upX + atUpX), upper(maxX * downX + atDownX));
        int z = Math.max(upper(minZ * upZ + atUpZ), upper(maxZ * downZ + atDownZ));
        double left = (minX * leftLowX + maxX * leftHighX) + (minZ * leftLowZ + maxZ * leftHighZ) + atLeft;
        double right = (minX * rightLowX + maxX * rightHighX) + (minZ * rightLowZ + maxZ * rightHighZ) + atRight;
        return Math.max(upper(left), upper(right)) > 0 ? Integer.MAX_VALUE : Math.max(Math.max(0, x), z);
    }

    /** The upper half of a double's bits: of numbers of at least 0, rounded down; below 0 of a negative number. */
    private static int upper(double x) {
        return (int) (Double.doubleToRawLongBits(x) >>> Integer.SIZE);
    }
}

package robosim.geometry.index.boxes;

/**
 * The keys by which a query in a sector of the plane orders boxes of four numbers: a lower bound of how far a box is within the
 * sector, infinite if it is beyond.
 *
 * <p>A box begins in a direction of the axes at a line, which the sector reaches at a distance that is its height times a
 * factor of the sector: four directions give four lower bounds. And no point of the sector is beyond one of its sides.
 */
public final class SectorKeys {
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

    private double upX;
    private double atUpX;
    private double downX;
    private double atDownX;
    private double upZ;
    private double atUpZ;
    private double downZ;
    private double atDownZ;
    /** The bits of a distance that nothing is beyond. */
    private long farthest;


    // The outward normals of the sides, and which coordinates of a box are least along them.
    private double leftX;
    private double leftZ;
    private double atLeft;
    private int fromLeftX;
    private int fromLeftZ;
    private double rightX;
    private double rightZ;
    private double atRight;
    private int fromRightX;
    private int fromRightZ;

    /**
     * Sets a sector about a unit vector.
     *
     * @param cos of half the opening angle, which is below 90 degrees
     * @param most at least the greatest magnitude of any coordinate of a box
     */
    public void start(double ox, double oz, double ux, double uz, double cos, double sin, double most) {
        double reach = Math.max(most, Math.max(Math.abs(ox), Math.abs(oz)));
        double pad = PAD * reach + Double.MIN_NORMAL;
        farthest = bits(ACROSS * reach + Double.MIN_NORMAL);
        upX = factor(ux, cos, sin);
        atUpX = (-ox - pad) * upX;
        downX = -factor(-ux, cos, sin);
        atDownX = (pad - ox) * downX;
        upZ = factor(uz, cos, sin);
        atUpZ = (-oz - pad) * upZ;
        downZ = -factor(-uz, cos, sin);
        atDownZ = (pad - oz) * downZ;
        leftX = -sin * ux - cos * uz;
        leftZ = cos * ux - sin * uz;
        atLeft = -(leftX * ox + leftZ * oz) - pad;
        fromLeftX = leftX > 0 ? 0 : 2;
        fromLeftZ = leftZ > 0 ? 1 : 3;
        rightX = cos * uz - sin * ux;
        rightZ = -sin * uz - cos * ux;
        atRight = -(rightX * ox + rightZ * oz) - pad;
        fromRightX = rightX > 0 ? 0 : 2;
        fromRightZ = rightZ > 0 ? 1 : 3;
    }

    /** The distance at which a sector reaches a line across an axis, of which its own axis has a share, per height. */
    private static double factor(double share, double cos, double sin) {
        double most = share >= cos ? 1 : cos * share + sin * Math.sqrt(Math.max(0, (1 - share) * (1 + share)));
        return most >= FLATTEST ? 1 / (most + PAD) : most > -FLATTEST ? 1 / (2 * FLATTEST) : NEVER;
    }

    /** The key of a box. */
    public double key(double[] boxes, int at) {
        return key(
                boxes[at + fromLeftX] * leftX + boxes[at + fromLeftZ] * leftZ + atLeft,
                boxes[at + fromRightX] * rightX + boxes[at + fromRightZ] * rightZ + atRight,
                boxes[at],
                boxes[at + 1],
                boxes[at + 2],
                boxes[at + 3]);
    }

    /** The key of one box of six numbers, whose heights are ignored. */
    public double keyOfObject(double[] boxes, int at) {
        double left = leftX * boxes[at + 3 * (fromLeftX >> 1)] + leftZ * boxes[at + 2 + 3 * (fromLeftZ >> 1)];
        double right = rightX * boxes[at + 3 * (fromRightX >> 1)] + rightZ * boxes[at + 2 + 3 * (fromRightZ >> 1)];
        return key(left + atLeft, right + atRight, boxes[at], boxes[at + 2], boxes[at + 3], boxes[at + 5]);
    }

    // The bits of numbers of at least 0 sort like the numbers, and those of negative ones are negative; the larger of two
    // longs takes no branch.
    private double key(double left, double right, double minX, double minZ, double maxX, double maxZ) {
        long x = Math.max(bits(minX * upX + atUpX), bits(maxX * downX + atDownX));
        long z = Math.max(bits(minZ * upZ + atUpZ), bits(maxZ * downZ + atDownZ));
        long least = Math.max(Math.max(0, x), z);
        return Math.max(bits(left), bits(right)) > 0 || least > farthest
                ? Double.POSITIVE_INFINITY
                : Double.longBitsToDouble(least);
    }

    private static long bits(double x) {
        return Double.doubleToRawLongBits(x);
    }
}

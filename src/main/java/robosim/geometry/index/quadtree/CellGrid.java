package robosim.geometry.index.quadtree;

/**
 * A world divided into {@code 2^52} by {@code 2^52} cells; gives the cell of a box's centre as whole numbers. From the
 * highest bit on, the bits of a cell's number say in which half of the world, of that half and so on it lies, so
 * cutting regions in four is exact.
 */
public final class CellGrid {
    static final int BITS = 52;
    private static final long COUNT = 1L << BITS;

    private final double originX;
    private final double originZ;
    private final double scaleX;
    private final double scaleZ;

    public CellGrid(double minX, double minZ, double maxX, double maxZ) {
        if (!(minX <= maxX) || !(minZ <= maxZ) || !Double.isFinite(maxX - minX) || !Double.isFinite(maxZ - minZ)) {
            throw new IllegalArgumentException("world must be finite and min at most max (got: x %s to %s, z %s to %s)"
                    .formatted(minX, maxX, minZ, maxZ));
        }
        originX = minX;
        originZ = minZ;
        scaleX = scale(maxX - minX);
        scaleZ = scale(maxZ - minZ);
    }

    /** The cell along X of a box of six numbers at an index of an array. */
    long x(double[] boxes, int at) {
        return cell(0.5 * boxes[at] + 0.5 * boxes[at + 3], originX, scaleX);
    }

    long z(double[] boxes, int at) {
        return cell(0.5 * boxes[at + 2] + 0.5 * boxes[at + 5], originZ, scaleZ);
    }

    /** The quarter, 0 to 3, in which a cell lies of a region that is cut at this bit. */
    static int quarter(int bit, long x, long z) {
        return (int) ((x >>> bit) & 1) | (int) ((z >>> bit) & 1) << 1;
    }

    // Monotonic in the coordinate, so cells are ordered stripes; points outside the world fall into the outermost.
    private static long cell(double place, double origin, double scale) {
        double steps = (place - origin) * scale;
        return steps <= 0 ? 0 : steps >= COUNT ? COUNT - 1 : (long) steps;
    }

    private static double scale(double extent) {
        double scale = COUNT / extent;
        return Double.isFinite(scale) ? scale : 0;
    }
}

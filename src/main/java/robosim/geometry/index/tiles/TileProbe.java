package robosim.geometry.index.tiles;

/**
 * Finds the objects of {@link Tiles} that may be near a small rectangle, each as often as the rectangle's tiles list
 * it; mostly that is one tile. Quantized bounds decide; in lists without them the outlines do. A branch on a list's
 * length would be mispredicted every other time, so the whole slot of a short list is read.
 *
 * <p>Why none is missed: if a rectangle of a reach below 2^30 steps ends within a window, its position is less than
 * 2^31 steps from the corner. So a difference, two products and a sum, each rounded by 2^-53 of itself, misplace that
 * end by less than 2^-19 steps, which is far below {@link Tiles#MARGIN}, by which every object's box is widened in the
 * lists and in its quantized bounds. In divided tiles steps are up to 2^12 times as fine, and the same end is misplaced
 * by less than 2^-7 of them: still below. An end beyond the window is treated as on its edge: an object that meets the
 * rectangle only there is listed on a neighbouring tile, or outside these tiles.
 */
public final class TileProbe {
    /** The target needs no more objects. */
    public static final int ENOUGH = -1;

    /** The rectangle lies on too many tiles. */
    public static final int TOO_MANY = 0;

    /** The target has seen all objects. */
    public static final int ALL = 1;

    /** The largest reach of a rectangle, in steps of tiles that are not nested. */
    private static final double MOST_REACH = 0x1p30;

    private double x;
    private double z;
    private double halfX;
    private double halfZ;
    private double most;

    /** Starts a query for a rectangle around a point, where no coordinate exceeds {@code mostAnywhere} in magnitude. */
    public void start(double placeX, double placeZ, double toX, double toZ, double mostAnywhere) {
        x = placeX;
        z = placeZ;
        halfX = toX;
        halfZ = toZ;
        most = mostAnywhere;
    }

    /**
     * Passes the objects found on some tiles to a target, unless the rectangle lies on more than {@code mostTiles} or
     * reaches too far.
     */
    public int query(Tiles over, int mostTiles, double[] outlines, NearTarget target) {
        return query(over, mostTiles, MOST_REACH, outlines, target);
    }

    private int query(Tiles over, int mostTiles, double mostReach, double[] outlines, NearTarget target) {
        double fromX = x - over.originX;
        double fromZ = z - over.originZ;
        double reachX = halfX * over.stepsX;
        double reachZ = halfZ * over.stepsZ;
        // Rounded towards 0; no object on the tiles is below 0.
        int lowX = (int) Math.fma(fromX, over.stepsX, -reachX);
        int lowZ = (int) Math.fma(fromZ, over.stepsZ, -reachZ);
        int highX = (int) Math.fma(fromX, over.stepsX, reachX);
        int highZ = (int) Math.fma(fromZ, over.stepsZ, reachZ);
        int tiles = ((lowX ^ highX) | (lowZ ^ highZ)) >> QuantizedBounds.STEP_BITS;
        int room = (over.countX << QuantizedBounds.STEP_BITS) - 1 - highX
                | (over.countZ << QuantizedBounds.STEP_BITS) - 1 - highZ;
        if (tiles == 0 && (lowX | lowZ | room) >= 0) {
            int tile = over.at(lowX >> QuantizedBounds.STEP_BITS, lowZ >> QuantizedBounds.STEP_BITS);
            int question = QuantizedBounds.question(lowX, lowZ, highX, highZ);
            return read(over, tile, question, outlines, target) ? ENOUGH : ALL;
        }
        boolean isFar = !(reachX < mostReach && reachZ < mostReach);
        return isFar ? TOO_MANY : queryMany(over, lowX, lowZ, highX, highZ, mostTiles, outlines, target);
    }

    private int queryMany(
            Tiles over, int x0, int z0, int x1, int z1, int mostTiles, double[] outlines, NearTarget target) {
        int lowX = cut(x0, over.countX);
        int lowZ = cut(z0, over.countZ);
        int highX = cut(x1, over.countX);
        int highZ = cut(z1, over.countZ);
        int column = lowX >> QuantizedBounds.STEP_BITS;
        int row = lowZ >> QuantizedBounds.STEP_BITS;
        int lastColumn = highX >> QuantizedBounds.STEP_BITS;
        int lastRow = highZ >> QuantizedBounds.STEP_BITS;
        if ((lastColumn - column + 1) * (lastRow - row + 1) > mostTiles) {
            return TOO_MANY;
        }
        for (int k = row; k <= lastRow; k++) {
            for (int j = column; j <= lastColumn; j++) {
                int question = QuantizedBounds.question(lowX, lowZ, highX, highZ, j, k);
                if (read(over, over.at(j, k), question, outlines, target)) {
                    return ENOUGH;
                }
            }
        }
        return ALL;
    }

    private static int cut(int step, int tiles) {
        return Math.max(0, Math.min(step, (tiles << QuantizedBounds.STEP_BITS) - 1));
    }

    private boolean read(Tiles over, int tile, int question, double[] outlines, NearTarget target) {
        int[] data = over.store.data;
        int[] quantizedBounds = over.store.quantizedBounds;
        if ((data[tile] & ~TileLists.SHORT) != 0 || quantizedBounds.length == 0) {
            return readOther(over, tile, question, outlines, target);
        }
        return (QuantizedBounds.mayTouch(question, quantizedBounds[tile + 1]) && target.visit(data[tile + 1]))
                || (QuantizedBounds.mayTouch(question, quantizedBounds[tile + 2]) && target.visit(data[tile + 2]))
                || (QuantizedBounds.mayTouch(question, quantizedBounds[tile + 3]) && target.visit(data[tile + 3]));
    }

    /** Reads a long list, a list without quantized bounds, or the lists within a divided tile. */
    private boolean readOther(Tiles over, int tile, int question, double[] outlines, NearTarget target) {
        int[] data = over.store.data;
        int[] quantizedBounds = over.store.quantizedBounds;
        int length = data[tile];
        if (length < 0) {
            Tiles inner = over.within(length);
            return readRows(inner, inner.rest(), outlines, target)
                    || query(inner, Integer.MAX_VALUE, Double.POSITIVE_INFINITY, outlines, target) == ENOUGH;
        }
        if (quantizedBounds.length == 0) {
            double slack = TileGathering.slack(x, z, halfX, halfZ, most);
            return over.mayMeetAny(x, z, halfX + slack, halfZ + slack) && readRows(over, tile, outlines, target);
        }
        int first = data[tile + 1];
        for (int k = first; k < first + length; k++) {
            if (QuantizedBounds.mayTouch(question, quantizedBounds[k]) && target.visit(data[k])) {
                return true;
            }
        }
        return false;
    }

    private boolean readRows(Tiles over, int tile, double[] outlines, NearTarget target) {
        int[] data = over.store.data;
        double slack = TileGathering.slack(x, z, halfX, halfZ, most);
        int first = TileLists.first(data, tile, data[tile]);
        for (int k = first; k < first + data[tile]; k++) {
            if (OrientedRectangle.mayTouch(outlines, data[k], x, z, halfX + slack, halfZ + slack)
                    && target.visit(data[k])) {
                return true;
            }
        }
        return false;
    }
}

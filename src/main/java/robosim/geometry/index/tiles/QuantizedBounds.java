package robosim.geometry.index.tiles;

/**
 * The bounds of a box relative to a tile, packed into one int: in units of 1/{@link #STEPS} of a tile, up to one and a
 * half tiles beyond it. They rule out most objects of a tile without reading their boxes.
 */
final class QuantizedBounds {
    static final int STEP_BITS = 5;

    /** Steps per tile. */
    static final int STEPS = 1 << STEP_BITS;

    /** The largest rounding error of a coordinate, in steps. */
    private static final double SLACK = STEPS * Tiles.MARGIN;

    private static final int BESIDE = 3 * STEPS / 2;
    private static final int MOST = 127;

    /** An offset that makes all relevant numbers positive, so that they can be truncated quickly. */
    private static final int BELOW = 4 * STEPS;

    private static final int HIGH_BITS = 0x80808080;

    /** The bounds of an object that is never ruled out. */
    static final int ANYWHERE = 0;

    /** Bounds that no query meets: they are too close to the end of the range. */
    static final int NOWHERE = MOST | MOST << 8 | MOST << 16 | MOST << 24;

    private QuantizedBounds() {}

    /** The lowest step of a coordinate given in tiles. */
    static int low(double place) {
        return Math.max(0, (int) (place * STEPS + (BELOW - SLACK))) - BELOW;
    }

    /** The highest step of a coordinate given in tiles. */
    static int high(double place) {
        return Math.max(0, (int) (place * STEPS + (BELOW + SLACK))) - BELOW;
    }

    /** The bounds of a box, given by its low and high steps, relative to a tile. */
    static int of(int lowX, int lowZ, int highX, int highZ, int column, int row) {
        int x = BESIDE - STEPS * column;
        int z = BESIDE - STEPS * row;
        return numbers(clamp(lowX + x), clamp(lowZ + z), MOST - clamp(highX + x), MOST - clamp(highZ + z));
    }

    /**
     * The query number that {@link #mayTouch} compares with the bounds of other boxes on a tile: how far they may begin,
     * and end.
     */
    static int question(int lowX, int lowZ, int highX, int highZ, int column, int row) {
        int x = BESIDE - STEPS * column;
        int z = BESIDE - STEPS * row;
        return numbers(reach(highX + x), reach(highZ + z), reach(MOST - lowX - x), reach(MOST - lowZ - z)) | HIGH_BITS;
    }

    /** The same for a box that lies on one tile only. */
    static int question(int lowX, int lowZ, int highX, int highZ) {
        int x = lowX & STEPS - 1;
        int z = lowZ & STEPS - 1;
        int toX = x + highX - lowX;
        int toZ = z + highZ - lowZ;
        return numbers(BESIDE + toX, BESIDE + toZ, MOST - BESIDE - x, MOST - BESIDE - z) | HIGH_BITS;
    }

    /** A box on a tile begins and ends less than a tile and a step beyond the tile's opposite side. */
    private static int reach(int steps) {
        return Math.max(0, Math.min(steps, MOST - 1));
    }

    private static int numbers(int a, int b, int c, int d) {
        return a | b << 8 | c << 16 | d << 24;
    }

    private static int clamp(int steps) {
        return Math.max(0, Math.min(steps, MOST));
    }

    /** Whether boxes may meet; false is always right. */
    static boolean mayTouch(int question, int quantized) {
        // Four comparisons in one subtraction: each borrows from its high bit if the number in the bounds is greater.
        return ((question - quantized) & HIGH_BITS) == HIGH_BITS;
    }
}

package robosim.geometry.index.tiles;

/**
 * A box as it lies about a tile, in one number: how far it reaches, in {@link #STEPS} of a tile, up to one and a half tiles
 * beside. It tells of most objects of a tile that they are not near without a look at where they are.
 */
final class QuantizedBounds {
    static final int STEP_BITS = 5;

    /** Parts of a tile. */
    static final int STEPS = 1 << STEP_BITS;

    /** What rounding may do to a place, in steps. */
    private static final double SLACK = STEPS * Tiles.MARGIN;

    private static final int BESIDE = 3 * STEPS / 2;
    private static final int MOST = 127;

    /** More than matters below 0: from there on numbers are positive, which are quickly cut. */
    private static final int BELOW = 4 * STEPS;

    private static final int HIGH_BITS = 0x80808080;

    /** Of what is always looked at. */
    static final int ANYWHERE = 0;

    /** Of nothing: so near to the end of all numbers does no question reach. */
    static final int NOWHERE = MOST | MOST << 8 | MOST << 16 | MOST << 24;

    private QuantizedBounds() {}

    /** The least step of a place, in tiles. */
    static int low(double place) {
        return Math.max(0, (int) (place * STEPS + (BELOW - SLACK))) - BELOW;
    }

    /** The greatest step of a place. */
    static int high(double place) {
        return Math.max(0, (int) (place * STEPS + (BELOW + SLACK))) - BELOW;
    }

    /** A box from low to high steps, about a tile. */
    static int of(int lowX, int lowZ, int highX, int highZ, int column, int row) {
        int x = BESIDE - STEPS * column;
        int z = BESIDE - STEPS * row;
        return numbers(clamp(lowX + x), clamp(lowZ + z), MOST - clamp(highX + x), MOST - clamp(highZ + z));
    }

    /** What to ask about other boxes on a tile for this one: how far they may begin, and end. */
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

    /** What lies on a tile begins and ends less than a tile and a step from its other end. */
    private static int reach(int steps) {
        return Math.max(0, Math.min(steps, MOST - 1));
    }

    private static int numbers(int a, int b, int c, int d) {
        return a | b << 8 | c << 16 | d << 24;
    }

    private static int clamp(int steps) {
        return Math.max(0, Math.min(steps, MOST));
    }

    /** Whether boxes may meet; never wrong where it says no. */
    static boolean mayMeet(int question, int sketch) {
        // Four comparisons in one subtraction: each borrows its high bit where the sketch's number is greater.
        return ((question - sketch) & HIGH_BITS) == HIGH_BITS;
    }
}

package robosim.geometry.index;

/**
 * How arrays with one element per object grow: few copies while they are small, little spare room when they are large.
 */
public final class ArrayGrowth {
    /** The initial capacity. */
    public static final int FIRST = 32;

    /** Arrays smaller than this grow to four times their size. */
    private static final int SMALL = 1 << 13;

    /** Arrays smaller than this are doubled. */
    private static final int MEDIUM = 1 << 15;

    /** Spare room for this many is not worth giving up. */
    private static final int FEW = 1024;

    private ArrayGrowth() {}

    /** Whether an array's spare room is worth giving up. */
    public static boolean isWasteful(int size, int capacity) {
        return capacity - size > FEW + (size >> 6);
    }

    /** The next capacity of a full array. */
    public static int of(int size) {
        return size < SMALL ? 4 * size + 2 : size < MEDIUM ? 2 * size + 2 : size + (size >> 2);
    }
}

package robosim.geometry.index;

/** How columns grow that have a place for each object: few copies while they are small, little to spare when they are large. */
public final class Growth {
    /** Room at first. */
    public static final int FIRST = 32;

    /** Fewer than these grow to four times as many. */
    private static final int SMALL = 1 << 13;

    /** Fewer than these grow by as many again. */
    private static final int MEDIUM = 1 << 15;

    /** Room for so many more is not worth giving up. */
    private static final int FEW = 1024;

    private Growth() {}

    /** Whether an array with room for more than its size wastes a thing worth mentioning. */
    public static boolean isWasteful(int size, int capacity) {
        return capacity - size > FEW + (size >> 6);
    }

    /** The next capacity of what is full with so many. */
    public static int of(int size) {
        return size < SMALL ? 4 * size + 2 : size < MEDIUM ? 2 * size + 2 : size + (size >> 2);
    }
}

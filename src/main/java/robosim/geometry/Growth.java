package robosim.geometry;

/** How columns grow: few copies while they are small, little to spare when they are large. */
final class Growth {
    private static final int SMALL = 1 << 15;

    /** Room for so many more is not worth giving up. */
    private static final int FEW = 1024;

    private Growth() {}

    /** Whether an array with room for more than its size wastes a thing worth mentioning. */
    static boolean isWasteful(int size, int capacity) {
        return capacity - size > FEW + (size >> 6);
    }

    /** The next capacity of what is full with so many. */
    static int of(int size) {
        return size < SMALL ? 2 * size + 2 : size + (size >> 2);
    }
}

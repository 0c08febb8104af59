package robosim.geometry;

/** How columns grow: few copies while they are small, little to spare when they are large. */
final class Growth {
    private static final int SMALL = 1 << 15;

    private Growth() {}

    /** The next capacity of what is full with so many. */
    static int of(int size) {
        return size < SMALL ? 2 * size + 2 : size + (size >> 1);
    }
}

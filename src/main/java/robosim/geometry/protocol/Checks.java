package robosim.geometry.protocol;

import java.util.List;

/** The rules for what comes from outside; each message names the argument and its value. Bits are kept as given. */
final class Checks {
    /** The largest coordinate, size or angle, as everywhere in the module. */
    static final double LIMIT = 0x1p100;

    private Checks() {}

    static void coordinate(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
    }

    static void size(String argument, double value) {
        if (!(value >= 0 && value <= LIMIT)) {
            throw new IllegalArgumentException(argument + " must be a number from 0 to 2^100 (got: " + value + ")");
        }
    }

    static void worldSize(String argument, double value) {
        if (!(value > 0 && value <= 2 * LIMIT)) {
            throw new IllegalArgumentException(argument + " must be above 0 and at most 2^101 (got: " + value + ")");
        }
    }

    static void radians(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be an angle in radians from -2^100 to 2^100 (got: " + value + ")");
        }
    }

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    /**
     * An immutable copy; a null list or item is refused by its place, and so is an item of another type, which a stream
     * can put into a list of any.
     */
    static <T> List<T> copy(String argument, List<T> items, Class<T> type) {
        int k = 0;
        for (Object item : present(argument, items)) {
            if (!type.isInstance(item)) {
                throw new IllegalArgumentException(argument + "[" + k + "] must be "
                        + (item == null
                                ? "given (got: null)"
                                : "a " + type.getSimpleName() + " (got: "
                                        + item.getClass().getName() + ")"));
            }
            k++;
        }
        return List.copyOf(items);
    }
}

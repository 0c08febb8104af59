package robosim.geometry.scenario;

import java.util.List;

/** The rule for this package's arguments. */
final class Given {
    private Given() {}

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    /** An immutable copy; a null list or item is refused. */
    static <T> List<T> copy(String argument, List<T> items) {
        int k = 0;
        for (T item : present(argument, items)) {
            present(argument + "[" + k++ + "]", item);
        }
        return List.copyOf(items);
    }
}

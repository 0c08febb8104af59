package robosim.geometry.exact;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Arguments that must be there: null is refused by the argument's name, as every other bad argument is. */
public final class Given {
    private Given() {}

    /** A value that is there. */
    public static <T> T present(String argument, @Nullable T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    /** A copy of a list that is there, as are all its elements. */
    public static <T> List<T> list(String argument, @Nullable List<? extends @Nullable T> values) {
        int k = 0;
        for (T value : present(argument, values)) {
            present(argument + "[" + k++ + "]", value);
        }
        @SuppressWarnings("unchecked") // none of them is null
        List<T> all = (List<T>) values;
        return List.copyOf(all);
    }
}

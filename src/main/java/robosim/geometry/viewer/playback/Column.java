package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Values by frame, each valid until the frame of the next value. */
final class Column<T> {
    private int[] numbers = new int[16];
    private final List<T> values = new ArrayList<>();

    /**
     * Adds a value from a frame on, which must not be before the last one's; a second value for the same frame replaces
     * the first.
     */
    void add(int number, T value) {
        int size = values.size();
        if (size > 0 && numbers[size - 1] == number) {
            values.set(size - 1, value);
            return;
        }
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        numbers[size] = number;
        values.add(value);
    }

    /** The index of the value that is valid in a frame; -1 before the first. */
    int index(int number) {
        int found = Arrays.binarySearch(numbers, 0, values.size(), number);
        return found >= 0 ? found : -found - 2;
    }

    /** Drops the values that are no longer valid in a frame and later. */
    void forget(int before) {
        int keep = Math.max(0, index(before));
        values.subList(0, keep).clear();
        System.arraycopy(numbers, keep, numbers, 0, values.size());
    }

    T value(int index) {
        return values.get(index);
    }

    /** The value that is valid in a frame; null before the first. */
    @Nullable
    T at(int number) {
        int index = index(number);
        return index < 0 ? null : values.get(index);
    }
}

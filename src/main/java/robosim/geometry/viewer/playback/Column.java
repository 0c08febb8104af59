package robosim.geometry.viewer.playback;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Values that hold from a frame on until the next one's, in the order of the frames. */
final class Column<T> {
    private int[] numbers = new int[16];
    private final List<T> values = new ArrayList<>();

    /** From a frame on, at least the last one's; a second value of one frame takes the first one's place. */
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

    /** Of the value that holds in a frame; -1 before the first. */
    int index(int number) {
        int found = Arrays.binarySearch(numbers, 0, values.size(), number);
        return found >= 0 ? found : -found - 2;
    }

    /** Lets go what holds no more in a frame and from there on. */
    void forget(int before) {
        int keep = Math.max(0, index(before));
        values.subList(0, keep).clear();
        System.arraycopy(numbers, keep, numbers, 0, values.size());
    }

    T value(int index) {
        return values.get(index);
    }

    /** The value that holds in a frame; null before the first. */
    @Nullable
    T at(int number) {
        int index = index(number);
        return index < 0 ? null : values.get(index);
    }
}

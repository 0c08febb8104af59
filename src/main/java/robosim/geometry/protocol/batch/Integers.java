package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import java.util.Arrays;
import robosim.geometry.check.Checks;

/**
 * Many whole numbers in one piece: an array in Java serialization, in JSON the base64 of their bytes, four each.
 *
 * @param values copied, on the way in and out
 */
@SuppressWarnings("ArrayRecordComponent") // copied, and compared by its elements
public record Integers(int[] values) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** No numbers. */
    public static final Integers NONE = new Integers(new int[0]);

    /** The most numbers that {@link #toString} shows. */
    private static final int SHOWN = 9;

    /** Refuses null. */
    public Integers {
        values = Checks.present("values", values).clone();
    }

    /** Numbers one by one. */
    public static Integers of(int... values) {
        return new Integers(values);
    }

    @Override
    public int[] values() {
        return values.clone();
    }

    /** How many there are. */
    public int size() {
        return values.length;
    }

    /** One of them. */
    public int get(int index) {
        if (index < 0 || index >= values.length) {
            throw new IllegalArgumentException(
                    "index must be from 0 to " + (values.length - 1) + " (got: " + index + ")");
        }
        return values[index];
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Integers that && Arrays.equals(values, that.values);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return values.length <= SHOWN
                ? Arrays.toString(values)
                : Arrays.toString(Arrays.copyOf(values, SHOWN)).replace("]", ", ... " + values.length + " numbers]");
    }
}

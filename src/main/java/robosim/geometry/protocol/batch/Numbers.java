package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.io.Serializable;
import java.util.Arrays;
import robosim.geometry.check.Checks;

/**
 * Many numbers in one piece: an array in Java serialization, in JSON the base64 of their bytes. Two are equal if all their
 * numbers have the same bits; NaN equals NaN.
 *
 * @param values copied, on the way in and out
 */
@SuppressWarnings("ArrayRecordComponent") // copied, and compared by its elements
public record Numbers(double[] values) implements Serializable {
    @Serial
    private static final long serialVersionUID = 1;

    /** No numbers. */
    public static final Numbers NONE = new Numbers(new double[0]);

    /** The most numbers that {@link #toString} shows. */
    private static final int SHOWN = 9;

    /** Refuses null. */
    public Numbers {
        values = Checks.present("values", values).clone();
    }

    /** Numbers one by one. */
    public static Numbers of(double... values) {
        return new Numbers(values);
    }

    @Override
    public double[] values() {
        return values.clone();
    }

    /** How many there are. */
    public int size() {
        return values.length;
    }

    /** One of them. */
    public double get(int index) {
        if (index < 0 || index >= values.length) {
            throw new IllegalArgumentException(
                    "index must be from 0 to " + (values.length - 1) + " (got: " + index + ")");
        }
        return values[index];
    }

    /** Copies some of them into an array. */
    public void copy(int from, int count, double[] out) {
        System.arraycopy(values, from, Checks.present("out", out), 0, count);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Numbers that && Arrays.equals(values, that.values);
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

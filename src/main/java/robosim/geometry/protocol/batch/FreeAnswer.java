package robosim.geometry.protocol.batch;

import java.io.Serial;
import java.util.Arrays;
import java.util.BitSet;
import robosim.geometry.check.Checks;

/**
 * Which poses or edges are free.
 *
 * @param count how many were asked
 * @param free  one bit for each, eight a byte, the first in the lowest bit; copied, on the way in and out. The layout of
 *              {@link BitSet#valueOf(byte[])}
 */
@SuppressWarnings("ArrayRecordComponent") // copied, and compared by its elements
public record FreeAnswer(int count, byte[] free) implements BatchAnswer {
    @Serial
    private static final long serialVersionUID = 1;

    /** Refuses null, a negative count, an array of another length than that many bits take, and bits beyond the last one. */
    public FreeAnswer {
        Checks.count(count);
        free = Checks.present("free", free).clone();
        int bytes = bytes(count);
        if (free.length != bytes) {
            throw new IllegalArgumentException(
                    "free must have " + bytes + " bytes for " + count + " bits (got: " + free.length + ")");
        }
        if (count % 8 != 0 && ((free[bytes - 1] & 0xff) >> (count % 8)) != 0) {
            throw new IllegalArgumentException("free must have no bits but its " + count + " (got: others)");
        }
    }

    /** An answer from bits in the layout of {@link BitSet#valueOf(long[])}. */
    public static FreeAnswer of(int count, long[] words) {
        byte[] bytes = new byte[bytes(Checks.count(count))];
        for (int k = 0; k < bytes.length; k++) {
            bytes[k] = (byte) (Checks.present("words", words)[k / 8] >>> (8 * (k % 8)));
        }
        return new FreeAnswer(count, bytes);
    }

    private static int bytes(int bits) {
        return (int) ((bits + 7L) / 8);
    }

    @Override
    public byte[] free() {
        return free.clone();
    }

    /** Whether a pose or edge is free. */
    public boolean isFree(int index) {
        if (index < 0 || index >= count) {
            throw new IllegalArgumentException("index must be from 0 to " + (count - 1) + " (got: " + index + ")");
        }
        return ((free[index / 8] >> (index % 8)) & 1) != 0;
    }

    @Override
    public boolean fits(BatchRequest request) {
        Checks.present("request", request);
        return (request instanceof FreePosesRequest || request instanceof FreeEdgesRequest) && request.size() == count;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof FreeAnswer that && count == that.count && Arrays.equals(free, that.free);
    }

    @Override
    public int hashCode() {
        return 31 * count + Arrays.hashCode(free);
    }

    @Override
    public String toString() {
        return "FreeAnswer[count=" + count + ", free=" + BitSet.valueOf(free) + "]";
    }
}

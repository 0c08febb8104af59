package robosim.geometry.protocol.json;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import robosim.geometry.protocol.batch.Integers;
import robosim.geometry.protocol.batch.Numbers;

/** The bytes of packed numbers: doubles of 8 bytes each, IEEE 754, the lowest byte first. */
final class PackedNumbers {
    private PackedNumbers() {}

    static byte[] bytes(Numbers numbers) {
        ByteBuffer bytes = ByteBuffer.allocate(Double.BYTES * numbers.size()).order(ByteOrder.LITTLE_ENDIAN);
        for (int k = 0; k < numbers.size(); k++) {
            bytes.putDouble(numbers.get(k));
        }
        return bytes.array();
    }

    /** Whole numbers have 4 bytes each, two's complement. */
    static byte[] bytes(Integers numbers) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * numbers.size()).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asIntBuffer().put(numbers.values());
        return bytes.array();
    }

    /** Takes a multiple of 4 bytes. */
    static Integers integers(byte[] bytes) {
        int[] values = new int[bytes.length / Integer.BYTES];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(values);
        return new Integers(values);
    }

    /** Takes a multiple of 8 bytes. */
    static Numbers numbers(byte[] bytes) {
        double[] values = new double[bytes.length / Double.BYTES];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer().get(values);
        return new Numbers(values);
    }
}

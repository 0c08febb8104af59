package robosim.geometry.protocol.json;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
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

    /** Takes a multiple of 8 bytes. */
    static Numbers numbers(byte[] bytes) {
        double[] values = new double[bytes.length / Double.BYTES];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer().get(values);
        return new Numbers(values);
    }

    /** Takes bytes as they are decoded, up to a limit. */
    static final class Sink extends OutputStream {
        private final int most;
        private byte[] bytes = new byte[256];
        private int count;
        private boolean isFull;

        Sink(int most) {
            this.most = most;
        }

        @Override
        public void write(int b) throws IOException {
            write(new byte[] {(byte) b}, 0, 1);
        }

        @Override
        public void write(byte[] from, int at, int length) throws IOException {
            if (length > most - count) {
                isFull = true;
                throw new IOException("full");
            }
            if (count + length > bytes.length) {
                bytes = Arrays.copyOf(bytes, (int) Math.min(most, Math.max(count + length, 2L * bytes.length)));
            }
            System.arraycopy(from, at, bytes, count, length);
            count += length;
        }

        int count() {
            return count;
        }

        /** Whether there were more. */
        boolean isFull() {
            return isFull;
        }

        byte[] bytes() {
            return Arrays.copyOf(bytes, count);
        }
    }
}

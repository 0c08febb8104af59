package robosim.geometry.world.shared;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;

/** A stream that counts the bytes read. */
public final class CountedStream extends FilterInputStream {
    /** Is given the number of bytes since the last call, and may end the reading. */
    @FunctionalInterface
    public interface Counter {
        void read(int bytes) throws IOException;
    }

    private final Counter counter;

    public CountedStream(InputStream in, Counter counter) {
        super(in);
        this.counter = counter;
    }

    /** A stream that fails when it exceeds the maximum size of a file. */
    public static CountedStream bounded(InputStream in) {
        long[] left = {Limits.MAX_BYTES};
        return new CountedStream(in, bytes -> {
            left[0] -= bytes;
            if (left[0] < 0) {
                throw new IOException("a file must have at most " + Limits.MAX_BYTES
                        + " bytes; split it in several files, or simplify what is in it (got: more)");
            }
        });
    }

    @Override
    public int read() throws IOException {
        int value = super.read();
        counter.read(value < 0 ? 0 : 1);
        return value;
    }

    @Override
    public int read(byte[] target, int from, int length) throws IOException {
        int count = super.read(target, from, length);
        counter.read(Math.max(0, count));
        return count;
    }
}

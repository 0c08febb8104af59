package robosim.geometry.world.shared;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;

/** A stream that fails when it exceeds the maximum size of a file. */
public final class Bounded extends FilterInputStream {
    private long left = Limits.MAX_BYTES;

    public Bounded(InputStream in) {
        super(in);
    }

    @Override
    public int read() throws IOException {
        int value = super.read();
        count(value < 0 ? 0 : 1);
        return value;
    }

    @Override
    public int read(byte[] target, int from, int length) throws IOException {
        int count = super.read(target, from, length);
        count(count);
        return count;
    }

    private void count(int bytes) throws IOException {
        left -= Math.max(0, bytes);
        if (left < 0) {
            throw new IOException("a file must have at most " + Limits.MAX_BYTES
                    + " bytes; split it in several files, or simplify what is in it (got: more)");
        }
    }
}

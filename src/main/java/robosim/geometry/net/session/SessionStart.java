package robosim.geometry.net.session;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;
import robosim.geometry.protocol.Bundle;
import robosim.geometry.protocol.MessageWriter;

/**
 * What each connection's session carries out before its peer's first request.
 *
 * @param bytes how many its messages would have, by which the memory of worlds is claimed
 */
public record SessionStart(List<Bundle> requests, int bytes) {
    /** Counts their bytes. */
    public static SessionStart of(List<Bundle> requests) {
        Counter counter = new Counter();
        try {
            MessageWriter writer = new MessageWriter(counter);
            for (Bundle request : requests) {
                writer.write(request);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("counting bytes cannot fail", e);
        }
        return new SessionStart(requests, (int) Math.min(Integer.MAX_VALUE, counter.bytes));
    }

    private static final class Counter extends OutputStream {
        private long bytes;

        @Override
        public void write(int single) {
            bytes++;
        }

        @Override
        public void write(byte[] from, int at, int length) {
            bytes += length;
        }
    }
}

package robosim.geometry.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.util.function.BooleanSupplier;
import robosim.geometry.net.watch.WatchServer;

/** The lines of a watcher as a stream; used by one thread, and closed by any. */
final class WatcherStream extends InputStream {
    private static final long MILLIS = 250;

    private final WatchServer.Lines lines;
    private final BooleanSupplier isOver;
    private byte[] present = new byte[0];
    private int at;
    private volatile boolean closed;

    WatcherStream(WatchServer.Lines lines, BooleanSupplier isOver) {
        this.lines = lines;
        this.isOver = isOver;
    }

    @Override
    public int read() throws IOException {
        byte[] single = new byte[1];
        return read(single, 0, 1) < 0 ? -1 : single[0] & 0xff;
    }

    @Override
    public int read(byte[] bytes, int from, int length) throws IOException {
        while (at == present.length) {
            if (closed) {
                return -1;
            }
            if (isOver.getAsBoolean()) {
                throw new IOException(String.valueOf(lines.problem()));
            }
            try {
                present = lines.next(MILLIS);
                at = 0;
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new InterruptedIOException("closed");
            }
        }
        int count = Math.min(length, present.length - at);
        System.arraycopy(present, at, bytes, from, count);
        at += count;
        return count;
    }

    @Override
    public void close() {
        closed = true;
        lines.close();
    }
}

package robosim.geometry.net;

import java.io.IOException;
import java.io.OutputStream;

/**
 * The way out to a peer. What is written goes to the socket's own queue, which is bounded; while it is full the writer
 * waits, and reads no further request of that peer.
 */
final class PacedOutput extends OutputStream {
    /** One step of the progress that is watched. */
    private static final int STEP_BYTES = 1 << 14;

    private final OutputStream out;
    private final Watchdog.Guard guard;
    private final Patience patience;
    private long messageDue;

    /** What is written next begins a message; each ends with a flush. */
    private boolean between = true;

    PacedOutput(OutputStream out, Watchdog.Guard guard, Patience patience) {
        this.out = out;
        this.guard = guard;
        this.patience = patience;
    }

    @Override
    public void write(int single) throws IOException {
        write(new byte[] {(byte) single}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int at, int length) throws IOException {
        if (between) {
            between = false;
            messageDue = System.nanoTime() + patience.message().toNanos();
        }
        int end = at + length;
        for (int from = at; from < end; from += STEP_BYTES) {
            step(bytes, from, Math.min(STEP_BYTES, end - from));
        }
    }

    private void step(byte[] bytes, int at, int length) throws IOException {
        long stalled = System.nanoTime() + patience.stall().toNanos();
        guard.begin(stalled - messageDue < 0 ? stalled : messageDue);
        try {
            out.write(bytes, at, length);
        } catch (IOException e) {
            throw guard.isBroken() ? new IOException(complaint(stalled), e) : e;
        } finally {
            guard.end();
        }
    }

    private String complaint(long stalled) {
        return stalled - messageDue < 0
                ? "the peer read nothing for " + patience.stall().toMillis() + " ms"
                : "the peer did not read a message within " + patience.message().toMillis() + " ms";
    }

    @Override
    public void flush() throws IOException {
        out.flush();
        between = true;
    }
}

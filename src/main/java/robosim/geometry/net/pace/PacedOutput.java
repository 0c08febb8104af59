package robosim.geometry.net.pace;

import java.io.IOException;
import java.io.OutputStream;
import java.time.Duration;

/**
 * The output to a peer. A message is buffered, so that a small one is a single write and a single segment; data goes to
 * the socket's send buffer, whose size is limited. While that is full the writer waits, without holding its {@link
 * CpuTurn}, and reads no further request of that peer.
 */
public final class PacedOutput extends OutputStream {
    /** The number of bytes after which progress is checked. */
    static final int STEP_BYTES = 1 << 14;

    private final OutputStream out;
    private final Watchdog.Guard guard;
    private final Duration stall;
    private final Duration message;
    private final CpuTurn turn;
    private final byte[] gathered = new byte[STEP_BYTES];
    private int count;
    private long messageDue;

    /** Whether the next byte written begins a message; each message ends with a flush. */
    private boolean between = true;

    public PacedOutput(OutputStream out, Watchdog.Guard guard, Duration stall, Duration message, CpuTurn turn) {
        this.out = out;
        this.guard = guard;
        this.stall = stall;
        this.message = message;
        this.turn = turn;
    }

    @Override
    public void write(int single) throws IOException {
        write(new byte[] {(byte) single}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int at, int length) throws IOException {
        int end = at + length;
        for (int from = at; from < end; ) {
            if (count == STEP_BYTES) {
                boolean computing = turn.isRunning();
                step();
                if (computing) {
                    long start = System.nanoTime();
                    turn.take();
                    messageDue += System.nanoTime() - start; // not the peer's fault
                }
            }
            int part = Math.min(STEP_BYTES - count, end - from);
            System.arraycopy(bytes, from, gathered, count, part);
            count += part;
            from += part;
        }
    }

    private void step() throws IOException {
        turn.give();
        if (between) {
            between = false;
            messageDue = System.nanoTime() + message.toNanos();
        }
        long stalled = System.nanoTime() + stall.toNanos();
        guard.begin(stalled - messageDue < 0 ? stalled : messageDue);
        try {
            out.write(gathered, 0, count);
            count = 0;
        } catch (IOException e) {
            throw guard.isBroken() ? new IOException(complaint(stalled), e) : e;
        } finally {
            guard.end();
        }
    }

    private String complaint(long stalled) {
        return stalled - messageDue < 0
                ? "the peer read nothing for " + stall.toMillis() + " ms"
                : "the peer did not read a message within " + message.toMillis() + " ms";
    }

    /** Ends a message. After it there is nothing to compute until the next one comes. */
    @Override
    public void flush() throws IOException {
        if (count > 0) {
            step();
        }
        out.flush();
        between = true;
    }
}

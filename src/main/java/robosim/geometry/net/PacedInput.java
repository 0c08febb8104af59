package robosim.geometry.net;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import robosim.geometry.protocol.MessagePace;

/** A socket's bytes: patient between messages, impatient inside one. */
final class PacedInput extends InputStream implements MessagePace {
    /** How long a peer may be silent before it gets our stream header, for which it may be waiting. */
    private static final int SILENCE_MILLIS = 300;

    private final Socket socket;
    private final InputStream in;
    private final long stallNanos;
    private final long messageNanos;
    private boolean opening;
    private boolean inside;
    private long deadline;

    PacedInput(Socket socket, Duration stallTime, Duration messageTime) throws IOException {
        this.socket = socket;
        this.in = socket.getInputStream();
        this.stallNanos = stallTime.toNanos();
        this.messageNanos = messageTime.toNanos();
    }

    @Override
    public void opening() {
        opening = true;
        inside = false;
    }

    @Override
    public void idle() {
        opening = false;
        inside = false;
    }

    @Override
    public void begun() {
        opening = false;
        inside = true;
        deadline = System.nanoTime() + messageNanos;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] into, int at, int length) throws IOException {
        socket.setSoTimeout(opening ? SILENCE_MILLIS : inside ? patience() : 0);
        return in.read(into, at, length);
    }

    /** Milliseconds, at least 1 because 0 would be for ever. */
    private int patience() throws SocketTimeoutException {
        long left = deadline - System.nanoTime();
        if (left <= 0) {
            throw new SocketTimeoutException();
        }
        return (int) Math.max(1, Math.min(left, stallNanos) / 1_000_000);
    }
}

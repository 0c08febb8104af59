package robosim.geometry.net.pace;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import robosim.geometry.protocol.MessagePace;
import robosim.geometry.protocol.ProtocolException;

/** A peer's bytes: patient between messages, impatient inside one. */
public final class PacedInput extends InputStream implements MessagePace {
    /** How long a peer may be silent before it gets our stream header, for which it may be waiting. */
    private static final int SILENCE_MILLIS = 300;

    /** Messages below that take no part of the room that all have. */
    private static final int LARGE_BYTES = 1 << 18;

    private final Socket socket;
    private final InputStream in;
    private final Watchdog.Guard guard;
    private final long stallNanos;
    private final long messageNanos;
    private final Turn turn;
    private final Room.Share room;
    private final BooleanSupplier stopping;
    private Duration idleTime;
    private boolean opening;
    private boolean inside;
    private long deadline;
    private long messageBytes;

    /**
     * Reads.
     *
     * @param socket   whose time-outs are set
     * @param in       its bytes, deciphered where they are ciphered
     * @param idle     how long a peer may be silent between two messages
     * @param stall    and within one
     * @param message  how long all of a message may take
     * @param turn     held from when bytes have come until they are waited for again
     * @param room     of which a large message takes its part until the next one is waited for
     * @param stopping from when on a failure is the end
     */
    public PacedInput(
            Socket socket,
            InputStream in,
            Watchdog.Guard guard,
            Duration idle,
            Duration stall,
            Duration message,
            Turn turn,
            Room.Share room,
            BooleanSupplier stopping) {
        this.socket = socket;
        this.in = in;
        this.guard = guard;
        this.stallNanos = stall.toNanos();
        this.messageNanos = message.toNanos();
        this.idleTime = idle;
        this.turn = turn;
        this.room = room;
        this.stopping = stopping;
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
        room.free();
    }

    @Override
    public void begun() {
        opening = false;
        inside = true;
        messageBytes = 0;
        deadline = System.nanoTime() + messageNanos;
        turn.hold();
    }

    /** From now on the peer may be idle for so long between two messages. */
    public void mayIdle(Duration time) {
        idleTime = time;
    }

    @Override
    public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] into, int at, int length) throws IOException {
        try {
            if (turn.isCutOff()) {
                throw new IOException("the connection was cut off");
            }
            if (inside && in.available() > 0) {
                compute();
            } else {
                turn.give();
                if (inside) {
                    SocketSettings.acknowledge(socket); // the rest may wait for that
                } else {
                    turn.rest();
                }
            }
            int got = inside ? readInside(into, at, length) : readIdle(into, at, length);
            if (inside) {
                count(got);
            }
            compute();
            return got;
        } catch (IOException e) {
            if (stopping.getAsBoolean() && !guard.isBroken()) {
                return -1;
            }
            throw e;
        }
    }

    /** Has the turn; what a message waits for that is not its peer's fault. */
    private void compute() {
        long start = System.nanoTime();
        turn.hold();
        deadline += System.nanoTime() - start;
    }

    /** What is large waits for its room. */
    private void count(int got) throws IOException {
        messageBytes += Math.max(0, got);
        if (messageBytes < LARGE_BYTES) {
            return;
        }
        long wanted = (messageBytes / LARGE_BYTES + 1) * LARGE_BYTES * Room.MEMORY_FOR_A_BYTE;
        if (!room.holds(wanted)) {
            turn.give();
            long start = System.nanoTime();
            room.growTo(wanted);
            deadline += System.nanoTime() - start; // others made it wait
        }
    }

    private int readIdle(byte[] into, int at, int length) throws IOException {
        socket.setSoTimeout(opening ? SILENCE_MILLIS : millis(idleTime.toNanos()));
        try {
            return in.read(into, at, length);
        } catch (SocketTimeoutException e) {
            if (opening) {
                throw e;
            }
            throw new ProtocolException(
                    "a peer must say something now and then, a ping or an empty MoveBundle if need be"
                            + " (got: silence for " + idleTime + ")");
        }
    }

    private int readInside(byte[] into, int at, int length) throws IOException {
        long left = deadline - System.nanoTime();
        if (left <= 0) {
            throw new SocketTimeoutException();
        }
        socket.setSoTimeout(millis(Math.min(left, stallNanos)));
        guard.begin(deadline); // one read of a cipher is several of the socket, each with that time-out
        try {
            return in.read(into, at, length);
        } catch (IOException e) {
            throw guard.isBroken() ? new SocketTimeoutException() : e;
        } finally {
            guard.end();
        }
    }

    /** At least 1 because 0 would be for ever. */
    private static int millis(long nanos) {
        return (int) Math.max(1, Duration.ofNanos(nanos).toMillis());
    }
}

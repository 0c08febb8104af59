package robosim.geometry.net.pace;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.ProtocolException;
import robosim.geometry.protocol.pace.MessagePace;

/** The input from a peer, with a long timeout between messages and short ones within a message. */
public final class PacedInput extends InputStream implements MessagePace {
    /** How long a new peer may be silent before it is sent our stream header, for which it may be waiting. */
    private static final int SILENCE_MILLIS = 300;

    /** Messages smaller than this are not counted against the shared memory. */
    private static final int LARGE_BYTES = 1 << 18;

    /** The first bytes of a message are read without the turn: hellos and pings have no more, and never wait for others. */
    private static final int FREE_BYTES = 1 << 12;

    private final Socket socket;
    private final InputStream in;
    private final Watchdog.Guard guard;
    private final long stallNanos;
    private final long messageNanos;
    private final CpuTurn turn;
    private final MessageMemory.Share memory;
    private final BooleanSupplier stopping;
    private Duration idleTime;
    private Admissions.@Nullable Newcomer newcomer;
    private boolean opening;
    private boolean inside;

    /**
     * Whether bytes have come that no answer acknowledges: a part of a message, an init, or the reset with which a sender
     * ends a message.
     */
    private boolean unanswered;

    private long deadline;
    private long messageBytes;

    /**
     * Reads from a socket.
     *
     * @param socket   whose time-outs are set
     * @param in       its bytes, deciphered where they are ciphered
     * @param idle     how long a peer may be silent between two messages
     * @param stall    and within one
     * @param message  how long all of a message may take
     * @param turn     held from when bytes have come until they are waited for again
     * @param memory   of which a large message takes its part until the next one is waited for
     * @param stopping from when on a failure is the end
     */
    public PacedInput(
            Socket socket,
            InputStream in,
            Watchdog.Guard guard,
            Duration idle,
            Duration stall,
            Duration message,
            CpuTurn turn,
            MessageMemory.Share memory,
            BooleanSupplier stopping) {
        this.socket = socket;
        this.in = in;
        this.guard = guard;
        this.stallNanos = stall.toNanos();
        this.messageNanos = message.toNanos();
        this.idleTime = idle;
        this.turn = turn;
        this.memory = memory;
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
        memory.free();
    }

    @Override
    public void begun() {
        opening = false;
        inside = true;
        messageBytes = 0;
        deadline = System.nanoTime() + messageNanos;
        compute();
    }

    /** Until this connection is admitted, its time is limited as a whole. */
    public void from(Admissions.Newcomer peer) {
        newcomer = peer;
    }

    /** An answer was sent, and with it the acknowledgement of all that has come. */
    public void answered() {
        unanswered = false;
    }

    /** Sets how long the peer may be idle between two messages. */
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
                if (!inside) {
                    turn.rest();
                }
                if (unanswered) {
                    SocketSettings.acknowledge(socket); // what follows may wait for that
                }
            }
            int got = inside ? readInside(into, at, length) : readIdle(into, at, length);
            unanswered |= got > 0;
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

    /** Takes the turn. The wait for it is not counted as the peer's time. */
    private void compute() {
        if (messageBytes < FREE_BYTES) {
            return; // a hello and a ping never wait for others
        }
        long start = System.nanoTime();
        turn.hold();
        allow(System.nanoTime() - start);
    }

    private void allow(long nanos) {
        deadline += nanos;
        Admissions.Newcomer stranger = stranger();
        if (stranger != null) {
            stranger.extend(nanos);
        }
    }

    /** The peer as long as it is not admitted; else null. */
    private Admissions.@Nullable Newcomer stranger() {
        Admissions.Newcomer peer = newcomer;
        return peer == null || peer.isAdmitted() ? null : peer;
    }

    /** Counts bytes; a large message waits for its share of memory. */
    private void count(int got) throws IOException {
        messageBytes += Math.max(0, got);
        if (messageBytes < LARGE_BYTES) {
            return;
        }
        Admissions.Newcomer stranger = stranger();
        if (stranger != null) {
            stranger.admit(); // the rest of a large first message has the time of any message
        }
        grow((messageBytes / LARGE_BYTES + 1) * LARGE_BYTES * MessageMemory.MEMORY_FOR_A_BYTE);
    }

    private void grow(long wanted) throws IOException {
        if (!memory.holds(wanted)) {
            turn.give();
            long start = System.nanoTime();
            memory.growTo(wanted);
            allow(System.nanoTime() - start); // the wait was not its fault
        }
    }

    /**
     * Waits until there is memory for the answer to the message that was read last, beside that of the message; it is held
     * until the next message is waited for.
     *
     * @param bytes for the work on it, which may be far more than the message has
     */
    public void needs(long bytes) throws IOException {
        long wanted = bytes + messageBytes * MessageMemory.MEMORY_FOR_A_BYTE;
        if (wanted >= (long) LARGE_BYTES * MessageMemory.MEMORY_FOR_A_BYTE) {
            grow(wanted);
            turn.hold();
        }
    }

    private int readIdle(byte[] into, int at, int length) throws IOException {
        long idle = opening ? SILENCE_MILLIS * 1_000_000L : idleTime.toNanos();
        Admissions.Newcomer stranger = stranger();
        try {
            if (stranger != null) {
                return readBefore(stranger, idle, into, at, length);
            }
            socket.setSoTimeout(millis(idle));
            return in.read(into, at, length);
        } catch (SocketTimeoutException e) {
            if (opening) {
                throw e;
            }
            throw new ProtocolException(
                    "a peer must send something from time to time, a ping or an empty MoveBundle if need be"
                            + " (got: silence for " + idleTime + ")");
        }
    }

    /** Reads from a peer that is not admitted; one read through TLS may be several reads of the socket. */
    private int readBefore(Admissions.Newcomer stranger, long pause, byte[] into, int at, int length)
            throws IOException {
        long due = stranger.due();
        long left = due - System.nanoTime();
        if (left <= 0) {
            throw stranger.late();
        }
        socket.setSoTimeout(millis(Math.min(left, pause)));
        guard.begin(due);
        try {
            return in.read(into, at, length);
        } catch (IOException e) {
            boolean late = left <= pause && e instanceof SocketTimeoutException;
            throw guard.isBroken() || late ? stranger.late() : e;
        } finally {
            guard.end();
        }
    }

    private int readInside(byte[] into, int at, int length) throws IOException {
        Admissions.Newcomer stranger = stranger();
        if (stranger != null && stranger.due() - deadline < 0) {
            return readBefore(stranger, stallNanos, into, at, length);
        }
        long left = deadline - System.nanoTime();
        if (left <= 0) {
            throw new SocketTimeoutException();
        }
        socket.setSoTimeout(millis(Math.min(left, stallNanos)));
        guard.begin(deadline); // one read through TLS may be several reads of the socket, each with that timeout
        try {
            return in.read(into, at, length);
        } catch (IOException e) {
            throw guard.isBroken() ? new SocketTimeoutException() : e;
        } finally {
            guard.end();
        }
    }

    /** At least 1, because 0 would mean no timeout. */
    private static int millis(long nanos) {
        return (int) Math.max(1, Duration.ofNanos(nanos).toMillis());
    }
}

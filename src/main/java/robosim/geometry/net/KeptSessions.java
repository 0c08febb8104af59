package robosim.geometry.net;

import java.net.InetAddress;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import robosim.geometry.net.pace.Watchdog;
import robosim.geometry.net.pace.WorldMemory;
import robosim.geometry.protocol.ProtocolException;

/**
 * Sessions of a server or client that outlive a dropped connection for a while: their peer resumes one by its token.
 *
 * <p>A session has one holder at a time. A peer that dials again may be faster than the module notices that its first connection
 * has gone, so whoever has the token ends the connection that still holds the session.
 */
final class KeptSessions {
    /** Most sessions that wait for their peers; the oldest makes room. */
    static final int MOST = 64;

    /** Most of these from one other machine: a robot has one. */
    static final int MOST_FROM_ONE = 8;

    /** How long the work of the connection that still holds a session may take to end. */
    private static final long LETTING_GO_MILLIS = 5000;

    private static final int TOKEN_BYTES = 16;

    private static final String NONE =
            "no session is kept for this token: it has expired, or made room for others; begin a new one, with an empty"
                    + " \"resume\"";

    private final Duration time;
    private final Watchdog watchdog;
    private final SecureRandom random = new SecureRandom();
    private final Map<String, Kept> sessions = new LinkedHashMap<>();
    private boolean isClosed;

    /** Keeps sessions for a time; none if it is zero. */
    KeptSessions(Duration time, Watchdog watchdog) {
        this.time = time;
        this.watchdog = watchdog;
    }

    /** A session with what belongs to it, whichever connection carries it. */
    static final class Kept {
        final Session session;
        final SessionListener listener;
        final WorldMemory.Share memory;

        /** Whether the session has not been sent a request yet. */
        boolean isNew = true;

        /** The id of the last request that was carried out; null if that had none. */
        @Nullable
        Object lastId;

        /** Null for a session that ends with its connection. */
        private @Nullable String token;

        /** Ends the connection that has it; null while it waits. */
        private @Nullable Runnable holder;

        private @Nullable InetAddress from;
        private String identity = "";
        private Watchdog.@Nullable Guard guard;

        Kept(Session session, SessionListener listener, WorldMemory.Share memory) {
            this.session = session;
            this.listener = listener;
            this.memory = memory;
        }

        /** The session is over. */
        void end() {
            memory.free();
            listener.ended();
        }
    }

    boolean isEnabled() {
        return !time.isZero();
    }

    /**
     * Makes a new session one that can be resumed.
     *
     * @param holder   ends the connection that has it
     * @param from     where its peer is; null if unknown
     * @param identity of the peer's certificate, which whoever resumes the session must have as well; empty without TLS
     * @return its token
     */
    synchronized String begin(Kept kept, Runnable holder, @Nullable InetAddress from, String identity) {
        byte[] bytes = new byte[TOKEN_BYTES];
        random.nextBytes(bytes);
        String token = HexFormat.of().formatHex(bytes);
        kept.token = token;
        kept.holder = holder;
        kept.from = from;
        kept.identity = identity;
        sessions.put(token, kept);
        return token;
    }

    /**
     * Gives a session to another connection of its peer, and ends the one that still holds it.
     *
     * @param holder ends that other connection
     * @throws ProtocolException if there is no such session
     */
    synchronized Kept resume(String token, Runnable holder, @Nullable InetAddress from, String identity)
            throws ProtocolException {
        long end = System.nanoTime() + LETTING_GO_MILLIS * 1_000_000;
        while (true) {
            Kept kept = sessions.get(token);
            if (kept == null || !kept.identity.equals(identity)) {
                throw new ProtocolException(NONE);
            }
            if (kept.holder == null) {
                unguard(kept);
                kept.holder = holder;
                kept.from = from;
                return kept;
            }
            kept.holder.run();
            long left = (end - System.nanoTime()) / 1_000_000;
            if (left <= 0) {
                throw new ProtocolException(
                        "the session is still busy with a request of its last connection; try again");
            }
            try {
                wait(left);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new ProtocolException("the module is shutting down", e);
            }
        }
    }

    /**
     * The connection that holds a session is over.
     *
     * @return whether the session is kept for its peer
     */
    synchronized boolean release(Kept kept, boolean isSound) {
        String token = kept.token;
        if (token == null) {
            return false;
        }
        notifyAll();
        if (isClosed || !isSound) {
            sessions.remove(token);
            return false;
        }
        kept.holder = null;
        sessions.remove(token); // the oldest are those that were released first
        sessions.put(token, kept);
        Watchdog.Guard guard = watchdog.guard(() -> expire(token, kept));
        kept.guard = guard;
        guard.begin(System.nanoTime() + time.toNanos());
        InetAddress from = kept.from;
        if (from != null && !from.isLoopbackAddress() && count(from) > MOST_FROM_ONE) {
            drop(from);
        }
        if (count(null) > MOST) {
            drop(null);
        }
        return true;
    }

    /** Ends the session that has waited longest, as its memory is needed; returns whether there was one. */
    synchronized boolean makeRoom() {
        return drop(null);
    }

    /** Keeps no session any more. */
    synchronized void close() {
        isClosed = true;
        while (drop(null)) {
            notifyAll();
        }
    }

    private synchronized void expire(String token, Kept kept) {
        if (kept.holder == null && sessions.remove(token, kept)) {
            unguard(kept);
            end(kept);
        }
    }

    /** How many sessions wait for a peer at an address, null for any. */
    private long count(@Nullable InetAddress from) {
        return sessions.values().stream().filter(each -> isWaiting(each, from)).count();
    }

    private static boolean isWaiting(Kept kept, @Nullable InetAddress from) {
        return kept.holder == null && (from == null || from.equals(kept.from));
    }

    private boolean drop(@Nullable InetAddress from) {
        for (Kept each : sessions.values()) {
            if (isWaiting(each, from)) {
                sessions.remove(String.valueOf(each.token));
                unguard(each);
                end(each);
                return true;
            }
        }
        return false;
    }

    private static void unguard(Kept kept) {
        if (kept.guard != null) {
            kept.guard.close();
            kept.guard = null;
        }
    }

    /** Its memory is free at once; its listener may have a file to write. */
    private static void end(Kept kept) {
        kept.memory.free();
        new Thread(kept::end, "geometry-session-end").start();
    }
}

package robosim.geometry.net.pace;

import java.net.InetAddress;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.protocol.ProtocolException;

/**
 * The connections of a server, of which those not admitted yet have a budget of their own, so that strangers cannot take
 * the places of peers. A connection is admitted when TLS, its secret and its first message have come.
 *
 * <p>When the budget is used up, the next connection displaces an older one that keeps the server waiting: the oldest from
 * its own address if that has its share, else the oldest from the address that has the most. A peer that waits for the
 * server is not displaced, so a crowd that dials at once is served.
 */
public final class Admissions {
    /** Most connections that are not admitted yet. They need a thread each, and a peer is admitted within milliseconds. */
    public static final int MOST = 128;

    /** Most of them from one address other than this machine's own: two addresses must not be able to fill the budget alone. */
    public static final int MOST_FROM_ONE = 48;

    /** No connection is displaced before this time: a handshake needs a few turns of a busy machine. */
    static final long GRACE_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

    /**
     * Nor before this number of ticks, unless it is much older. On a machine that is busy a peer may not run for seconds,
     * and then a tick takes longer too.
     */
    private static final int GRACE_TICKS = 40;

    private static final long LONG_GRACE_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** The longest wait for a place; after it the oldest connection is displaced even if the server keeps it waiting. */
    static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(2);

    private static final long TICK_MILLIS = 5;

    private final int mostAdmitted;
    private final LongSupplier clock;

    /** Those not admitted yet, oldest first. */
    private final Set<Newcomer> waiting = new LinkedHashSet<>();

    private int admitted;

    /** How many ticks newcomers have waited for a place. */
    private int ticks;

    /** Takes the maximum number of admitted connections, and a clock like {@link System#nanoTime}. */
    public Admissions(int mostAdmitted, LongSupplier clock) {
        this.mostAdmitted = mostAdmitted;
        this.clock = clock;
    }

    /** Whether no further connection can be admitted at present. */
    public synchronized boolean isFull() {
        return admitted >= mostAdmitted;
    }

    /** Why a connection cannot be admitted if {@link #isFull}. */
    public String fullness() {
        return "there must be at most " + mostAdmitted + " connections (got: more); close one, or dial again later";
    }

    /** How many connections are not admitted yet. */
    public synchronized int waiting() {
        return waiting.size();
    }

    /**
     * Takes a new connection in, which may displace another one; waits for at most two seconds.
     *
     * @param from   the peer's address
     * @param nanos  how long it may take until it is admitted
     * @param idle   whether the server waits for it, and not it for the server
     * @param leave  closes it without blocking
     */
    public Newcomer enter(InetAddress from, long nanos, BooleanSupplier idle, Runnable leave)
            throws InterruptedException {
        Newcomer newcomer = new Newcomer(this, from, nanos, idle, leave);
        Newcomer displaced;
        while ((displaced = place(newcomer)) != null) {
            displaced.leave.run();
        }
        return newcomer;
    }

    /** Gives a newcomer its place; if there is none, removes another one, which is returned. */
    private synchronized @Nullable Newcomer place(Newcomer newcomer) throws InterruptedException {
        long end = newcomer.since + PATIENCE_NANOS;
        InetAddress crowd = crowd(newcomer.from);
        while (crowd != null) {
            Newcomer victim = victim(crowd, clock.getAsLong() - end >= 0);
            if (victim != null) {
                waiting.remove(victim);
                return victim;
            }
            wait(TICK_MILLIS);
            ticks++;
            crowd = crowd(newcomer.from);
        }
        waiting.add(newcomer);
        return null;
    }

    /** The address that must give up a place for one from the given address; null if there is room. */
    private @Nullable InetAddress crowd(InetAddress from) {
        Map<InetAddress, Integer> counts = new HashMap<>();
        InetAddress most = from;
        for (Newcomer each : waiting) {
            int count = counts.merge(each.from, 1, Integer::sum);
            most = count > counts.getOrDefault(most, 0) ? each.from : most;
        }
        if (!from.isLoopbackAddress() && counts.getOrDefault(from, 0) >= MOST_FROM_ONE) {
            return from;
        }
        return waiting.size() >= MOST ? most : null;
    }

    private @Nullable Newcomer victim(InetAddress address, boolean anyhow) {
        long now = clock.getAsLong();
        for (Newcomer each : waiting) {
            if (each.from.equals(address) && (anyhow || (isOld(each, now) && each.idle.getAsBoolean()))) {
                return each;
            }
        }
        return null;
    }

    private boolean isOld(Newcomer newcomer, long now) {
        long age = now - newcomer.since;
        return age >= LONG_GRACE_NANOS || (age >= GRACE_NANOS && ticks - newcomer.tick >= GRACE_TICKS);
    }

    private synchronized void admit(Newcomer newcomer) throws ProtocolException {
        if (newcomer.isAdmitted || !waiting.contains(newcomer)) {
            return; // or displaced, so that its socket is closed
        }
        if (isFull()) {
            throw new ProtocolException(fullness());
        }
        waiting.remove(newcomer);
        admitted++;
        newcomer.isAdmitted = true;
        notifyAll();
    }

    private synchronized void leave(Newcomer newcomer) {
        if (newcomer.isAdmitted) {
            admitted--;
            newcomer.isAdmitted = false;
        }
        waiting.remove(newcomer);
        notifyAll();
    }

    /** The place of one connection. */
    public static final class Newcomer {
        private final @Nullable Admissions admissions;
        private final InetAddress from;
        private final BooleanSupplier idle;
        private final Runnable leave;
        private final long since;
        private final int tick;
        private final long nanos;
        private volatile boolean isAdmitted;

        /** By when it must be admitted, a {@link System#nanoTime}; moved only by the connection's own thread. */
        private long due;

        private Newcomer(
                @Nullable Admissions admissions, InetAddress from, long nanos, BooleanSupplier idle, Runnable leave) {
            this.admissions = admissions;
            this.from = from;
            this.idle = idle;
            this.leave = leave;
            this.since = admissions == null ? System.nanoTime() : admissions.clock.getAsLong();
            this.tick = admissions == null ? 0 : admissions.ticks;
            this.due = since + nanos;
            this.nanos = nanos;
        }

        /** The connection of a client, which chose its peer: it is admitted from the start. */
        public static Newcomer chosen() {
            Newcomer chosen = new Newcomer(null, InetAddress.getLoopbackAddress(), 0, () -> false, () -> {});
            chosen.isAdmitted = true;
            return chosen;
        }

        /** Admits it; does nothing the second time. Throws if there are too many connections. */
        public void admit() throws ProtocolException {
            if (admissions != null && !isAdmitted) {
                admissions.admit(this);
            }
        }

        public boolean isAdmitted() {
            return isAdmitted;
        }

        /** By when it must be admitted. */
        public long due() {
            return due;
        }

        /** Allows for a wait that was not the peer's fault. */
        void extend(long more) {
            due += more;
        }

        /** Why it is closed if it is not admitted by then. */
        ProtocolException late() {
            return new ProtocolException("a new peer must send its first message, with TLS and a secret where they are"
                    + " needed, within " + TimeUnit.NANOSECONDS.toMillis(nanos) + " ms (got: less in that time)");
        }

        /** Gives its place back when the connection is over. */
        public void leave() {
            if (admissions != null) {
                admissions.leave(this);
            }
        }
    }
}

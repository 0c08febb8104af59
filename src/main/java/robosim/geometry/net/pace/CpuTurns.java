package robosim.geometry.net.pace;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Schedules which connections may compute, so that the requests of one delay the others only briefly. Waiting for a
 * peer to send or to receive bytes does not count as computing.
 *
 * <ul>
 *   <li>The need of a connection is the processor time it has used since it was last idle, or the average of earlier such
 *       bursts, whichever is more. Below a millisecond it is short, else long.
 *   <li>There are as many turns for short work as processors, and as many for long work. So short requests need not
 *       wait until a long one gives way; which of the two runs is left to the operating system, which prefers threads
 *       that have slept.
 *   <li>A turn of long work ends after a time slice if others wait. Among those waiting, the one with the smallest need
 *       is next; every fourth turn goes to the one that has waited longest, so each gets at least a quarter of a fair
 *       share.
 *   <li>Heavy work (the first queries of a large world, and connections that did not give way in time before) may use
 *       all turns for long work except one, but always at least one.
 *   <li>A connection that does not give way for long, within one long query, keeps computing, and its turn is lent to
 *       another one. This is possible for as many connections as there are processors.
 * </ul>
 */
public final class CpuTurns {
    /** How long a turn lasts while others wait. */
    static final long SLICE_NANOS = 2_000_000;

    /** How long a waiting connection lets a turn overrun before the turn is lent to it. */
    static final long PATIENCE_NANOS = 10_000_000;

    /** Connections that need less than this use the turns for short work. */
    static final long SHORT_NANOS = 1_000_000;

    /** One turn in this many goes to the connection that has waited longest. */
    private static final int EVERY = 4;

    private final int most;
    private final int mostHeavy;
    private final LongSupplier clock;
    private final LongSupplier cpu;
    private final List<CpuTurn> waiting = new ArrayList<>();
    private final List<CpuTurn> running = new ArrayList<>();

    /** Of the running connections, how many do short work, how many heavy work, and how many have lent their turn. */
    private int brief;

    private int heavy;
    private int lent;

    private long granted;
    private long tickets;
    private volatile boolean wanted;

    /** Takes the number of turns of each sort, and a clock like {@link System#nanoTime}. */
    public CpuTurns(int most, LongSupplier clock) {
        this(most, clock, clock);
    }

    /** Takes also a clock of the processor time of the calling thread. */
    CpuTurns(int most, LongSupplier clock, LongSupplier cpu) {
        this.most = most;
        this.cpu = cpu;
        this.mostHeavy = Math.max(1, most - 1);
        this.clock = clock;
    }

    /** As many turns as there are processors. */
    public static CpuTurns ofThisMachine() {
        return new CpuTurns(Runtime.getRuntime().availableProcessors(), System::nanoTime, ofThread());
    }

    /** The processor time of the calling thread; where it is not known, the time. */
    public static LongSupplier ofThread() {
        try {
            return Threads.cpuTime();
        } catch (NoClassDefFoundError e) {
            return System::nanoTime; // there is no java.management
        }
    }

    /** The only class that needs java.management, so that the others load without it. */
    private static final class Threads {
        private Threads() {}

        static LongSupplier cpuTime() {
            ThreadMXBean threads = ManagementFactory.getThreadMXBean();
            boolean isKnown = threads.isCurrentThreadCpuTimeSupported() && threads.isThreadCpuTimeEnabled();
            return isKnown ? threads::getCurrentThreadCpuTime : System::nanoTime;
        }
    }

    long cpuTime() {
        return cpu.getAsLong();
    }

    /** The turn of one connection, not held yet. */
    public CpuTurn turn() {
        return new CpuTurn(this);
    }

    /** Requests the turn; {@link CpuTurn#isWaiting} tells whether the connection must wait. */
    synchronized void ask(CpuTurn turn) {
        turn.state = CpuTurn.State.WAITING;
        turn.ticket = tickets++;
        turn.asked = clock.getAsLong();
        waiting.add(turn);
        grant();
    }

    /** Gives the turn back, or stops waiting for it. */
    synchronized void leave(CpuTurn turn) {
        end(turn);
        waiting.remove(turn);
        turn.state = CpuTurn.State.IDLE;
        grant();
    }

    /** Gives way if its time slice is over and others wait; it then waits among them. */
    synchronized void giveWay(CpuTurn turn) {
        long slice = turn.isBrief ? SHORT_NANOS : SLICE_NANOS;
        if (turn.state == CpuTurn.State.RUNNING && (turn.isLent || clock.getAsLong() - turn.since >= slice)) {
            end(turn);
            ask(turn);
        }
    }

    private void end(CpuTurn turn) {
        if (!running.remove(turn)) {
            return;
        }
        turn.computed(clock.getAsLong());
        count(turn, -1);
        turn.isLent = false;
    }

    private void count(CpuTurn turn, int more) {
        if (turn.isLent) {
            lent += more;
        } else if (turn.isBrief) {
            brief += more;
        } else {
            heavy += turn.countsAsHeavy ? more : 0;
        }
    }

    private void grant() {
        CpuTurn next = next();
        while (next != null) {
            granted++;
            waiting.remove(next);
            running.add(next);
            next.begin(clock.getAsLong());
            count(next, 1);
            next.wake();
            next = next();
        }
        wanted = !waiting.isEmpty();
    }

    private @Nullable CpuTurn next() {
        return granted % EVERY == EVERY - 1 ? longestWaiting() : leastNeeding();
    }

    private boolean mayRun(CpuTurn turn) {
        if (turn.need() < SHORT_NANOS && !turn.isHeavy()) {
            return brief < most;
        }
        return running.size() - brief - lent < most && (heavy < mostHeavy || !turn.isHeavy());
    }

    private @Nullable CpuTurn longestWaiting() {
        CpuTurn first = null;
        for (CpuTurn turn : waiting) {
            first = mayRun(turn) && (first == null || turn.ticket < first.ticket) ? turn : first;
        }
        return first;
    }

    private @Nullable CpuTurn leastNeeding() {
        CpuTurn first = null;
        for (CpuTurn turn : waiting) {
            boolean before = first == null
                    || turn.need() < first.need()
                    || (turn.need() == first.need() && turn.ticket < first.ticket);
            first = mayRun(turn) && before ? turn : first;
        }
        return first;
    }

    /** Lends turns of connections that should have given way to this one long ago. */
    synchronized void lend(CpuTurn impatient) {
        long now = clock.getAsLong();
        if (impatient.state != CpuTurn.State.WAITING || now - impatient.asked < PATIENCE_NANOS) {
            return;
        }
        for (CpuTurn turn : running) {
            if (!turn.isLent && lent < most && now - turn.since >= SLICE_NANOS + PATIENCE_NANOS) {
                count(turn, -1);
                turn.isLent = true;
                count(turn, 1);
            }
        }
        grant();
    }

    /** Whether any connection waits; may be slightly out of date. */
    boolean areWanted() {
        return wanted;
    }
}

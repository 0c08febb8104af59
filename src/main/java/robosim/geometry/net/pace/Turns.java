package robosim.geometry.net.pace;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Who may compute, so that what one connection asks costs the others a short wait and no more. Waiting for a peer's bytes,
 * or for a peer to take some, is no computing.
 *
 * <ul>
 *   <li>What a connection needs is what it has computed since it last had nothing to do, or what it computed before in
 *       such a time on average, whichever is more. Below a millisecond that is short, else long.
 *   <li>There are as many turns for short work as there are processors, and as many for long work. So short questions need
 *       not wait until a long one gives way; which of the two runs then is decided by the system, which prefers threads
 *       that have slept.
 *   <li>A turn of long work is over after a slice where others wait. Of those that wait, the one is first that needs the
 *       least; every fourth turn goes to whoever has waited longest, so that each has at least a quarter of a fair share.
 *   <li>Heavy work (the first questions to a large world, and what did not give way in time before) has all turns for long
 *       work but one, and always at least one.
 *   <li>Whoever does not give way for long, within one long question, keeps computing, and another may have its turn.
 *       That holds for as many as there are processors.
 * </ul>
 */
public final class Turns {
    /** How long a turn lasts while others wait. */
    static final long SLICE_NANOS = 2_000_000;

    /** How long one that waits lets a turn overrun before it has the turn lent. */
    static final long PATIENCE_NANOS = 10_000_000;

    /** Whoever needs less has turns of his own. */
    static final long SHORT_NANOS = 1_000_000;

    /** One turn in so many goes to whoever has waited longest. */
    private static final int EVERY = 4;

    private final int most;
    private final int mostHeavy;
    private final LongSupplier clock;
    private final List<Turn> waiting = new ArrayList<>();
    private final List<Turn> running = new ArrayList<>();

    /** How many of those that run do short work, how many of the others heavy work, and how many have lent their turn. */
    private int brief;

    private int heavy;
    private int lent;

    private long granted;
    private long tickets;
    private volatile boolean wanted;

    /** Of that many at a time; a clock as {@link System#nanoTime}. */
    public Turns(int most, LongSupplier clock) {
        this.most = most;
        this.mostHeavy = Math.max(1, most - 1);
        this.clock = clock;
    }

    /** As many as there are processors. */
    public static Turns ofThisMachine() {
        return new Turns(Runtime.getRuntime().availableProcessors(), System::nanoTime);
    }

    /** For one connection, which has no turn yet. */
    public Turn turn() {
        return new Turn(this);
    }

    /** It wants to compute; {@link Turn#isWaiting} tells whether it must wait. */
    synchronized void ask(Turn turn) {
        turn.state = Turn.State.WAITING;
        turn.ticket = tickets++;
        turn.asked = clock.getAsLong();
        waiting.add(turn);
        grant();
    }

    /** It computes no more, or waits no more. */
    synchronized void leave(Turn turn) {
        end(turn);
        waiting.remove(turn);
        turn.state = Turn.State.IDLE;
        grant();
    }

    /** Gives way where its slice is over and others wait; it then waits among them. */
    synchronized void giveWay(Turn turn) {
        long slice = turn.isBrief ? SHORT_NANOS : SLICE_NANOS;
        if (turn.state == Turn.State.RUNNING && (turn.isLent || clock.getAsLong() - turn.since >= slice)) {
            end(turn);
            ask(turn);
        }
    }

    private void end(Turn turn) {
        if (!running.remove(turn)) {
            return;
        }
        turn.computed(clock.getAsLong() - turn.since);
        count(turn, -1);
        turn.isLent = false;
    }

    private void count(Turn turn, int more) {
        if (turn.isLent) {
            lent += more;
        } else if (turn.isBrief) {
            brief += more;
        } else {
            heavy += turn.countsAsHeavy ? more : 0;
        }
    }

    private void grant() {
        Turn next = next();
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

    private @Nullable Turn next() {
        return granted % EVERY == EVERY - 1 ? longestWaiting() : leastNeeding();
    }

    private boolean mayRun(Turn turn) {
        if (turn.need() < SHORT_NANOS && !turn.isHeavy()) {
            return brief < most;
        }
        return running.size() - brief - lent < most && (heavy < mostHeavy || !turn.isHeavy());
    }

    private @Nullable Turn longestWaiting() {
        Turn first = null;
        for (Turn turn : waiting) {
            first = mayRun(turn) && (first == null || turn.ticket < first.ticket) ? turn : first;
        }
        return first;
    }

    private @Nullable Turn leastNeeding() {
        Turn first = null;
        for (Turn turn : waiting) {
            boolean before = first == null
                    || turn.need() < first.need()
                    || (turn.need() == first.need() && turn.ticket < first.ticket);
            first = mayRun(turn) && before ? turn : first;
        }
        return first;
    }

    /** Has the turns lent of those that should have given way to this one long ago. */
    synchronized void lend(Turn impatient) {
        long now = clock.getAsLong();
        if (impatient.state != Turn.State.WAITING || now - impatient.asked < PATIENCE_NANOS) {
            return;
        }
        for (Turn turn : running) {
            if (!turn.isLent && lent < most && now - turn.since >= SLICE_NANOS + PATIENCE_NANOS) {
                count(turn, -1);
                turn.isLent = true;
                count(turn, 1);
                turn.heavy();
            }
        }
        grant();
    }

    /** Whether anybody waits; may be a moment old. */
    boolean areWanted() {
        return wanted;
    }
}

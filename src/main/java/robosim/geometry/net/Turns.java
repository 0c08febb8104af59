package robosim.geometry.net;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Who may compute: as many connections at a time as there are processors, each for a slice, so that what one asks costs
 * the others a wait of some slices and no more. Waiting for a peer's bytes, or for a peer to take some, is no computing.
 *
 * <ul>
 *   <li>Of those that wait, the one is first that needs the least: its key is what it has computed since it last had
 *       nothing to do, or what it computed before in such a time on average, whichever is more. So short questions pass
 *       long ones.
 *   <li>Every fourth turn goes to whoever has waited longest, so that long ones are not held off for ever.
 *   <li>Those that do heavy work (messages above a megabyte, the first questions to a large world) have all turns but one
 *       between them, since they cannot always give way in time.
 *   <li>Whoever does not give way for long, within one long question, keeps computing, and another may have its turn.
 *       That holds for as many as there are processors.
 * </ul>
 */
final class Turns {
    /** How long a turn lasts while others wait. */
    static final long SLICE_NANOS = 2_000_000;

    /** How long one that waits lets a turn overrun before it has the turn lent. */
    static final long PATIENCE_NANOS = 10_000_000;

    /** One turn in so many goes to whoever has waited longest. */
    private static final int EVERY = 4;

    private final int most;
    private final int mostHeavy;
    private final LongSupplier clock;
    private final List<Turn> waiting = new ArrayList<>();
    private final List<Turn> running = new ArrayList<>();
    private int heavy;

    /** How many of those that run do so beside the turns that there are. */
    private int lent;

    private long granted;
    private long tickets;
    private volatile boolean wanted;

    /** Of that many at a time; a clock as {@link System#nanoTime}. */
    Turns(int most, LongSupplier clock) {
        this.most = most;
        this.mostHeavy = Math.max(1, most - 1);
        this.clock = clock;
    }

    /** As many as there are processors. */
    static Turns ofThisMachine() {
        return new Turns(Runtime.getRuntime().availableProcessors(), System::nanoTime);
    }

    /** For one connection, which has no turn yet. */
    Turn turn() {
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
        if (turn.state == Turn.State.RUNNING && (turn.isLent || clock.getAsLong() - turn.since >= SLICE_NANOS)) {
            end(turn);
            ask(turn);
        }
    }

    private void end(Turn turn) {
        if (!running.remove(turn)) {
            return;
        }
        turn.computed(clock.getAsLong() - turn.since);
        heavy -= turn.countsAsHeavy ? 1 : 0;
        lent -= turn.isLent ? 1 : 0;
        turn.isLent = false;
    }

    private void grant() {
        while (running.size() - lent < most) {
            Turn next = granted % EVERY == EVERY - 1 ? longestWaiting() : leastNeeding();
            if (next == null) {
                break;
            }
            granted++;
            waiting.remove(next);
            running.add(next);
            next.begin(clock.getAsLong());
            heavy += next.countsAsHeavy ? 1 : 0;
            next.wake();
        }
        wanted = !waiting.isEmpty();
    }

    private boolean mayRun(Turn turn) {
        return heavy < mostHeavy || !turn.isHeavy();
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
                turn.isLent = true;
                turn.heavy();
                lent++;
            }
        }
        grant();
    }

    /** Whether anybody waits; may be a moment old. */
    boolean areWanted() {
        return wanted;
    }
}

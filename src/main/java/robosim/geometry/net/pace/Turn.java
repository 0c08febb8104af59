package robosim.geometry.net.pace;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** One connection's right to compute, now and then. All but {@link #cutOff} is called by the connection's own thread. */
public final class Turn {
    /** How many turns one counts as heavy after it did heavy work. */
    private static final int HEAVY_TURNS = 8;

    private final Turns turns;

    /** Whether it must compute no more. */
    private volatile boolean isCutOff;

    private volatile @Nullable Thread thread;

    // What follows is guarded by the turns.

    enum State {
        IDLE,
        WAITING,
        RUNNING
    }

    volatile State state = State.IDLE;

    /** When it last began to wait, and the how-manieth that was. */
    long asked;

    long ticket;

    /** When it last began to compute. */
    long since;

    boolean isLent;
    boolean isBrief;
    boolean countsAsHeavy;
    private int heavyTurns;

    /** Nanoseconds computed since it last had nothing to do. */
    private long burst;

    /** What a burst took on average; of a new one nothing is known. */
    private long usual = Turns.SLICE_NANOS;

    Turn(Turns turns) {
        this.turns = turns;
    }

    /** Thrown by {@link #breathe} where a connection must compute no more. */
    public static final class CutOff extends RuntimeException {
        private static final long serialVersionUID = 1;

        public CutOff() {
            super("cut off", null, false, false);
        }
    }

    /** Waits for the turn. Returns early, without it, where this is cut off. */
    void take() {
        thread = Thread.currentThread();
        turns.ask(this);
        await();
    }

    /** Has the turn, from now or from before; gives way to others in time. */
    void hold() {
        if (state == State.IDLE) {
            take();
        } else if (turns.areWanted()) {
            turns.giveWay(this);
            await();
        }
    }

    /** Computes no more, for a while. */
    public void give() {
        if (state != State.IDLE) {
            turns.leave(this);
        }
    }

    /** There is nothing to do: what comes next is something new. */
    void rest() {
        synchronized (turns) {
            usual += (burst - usual) / 4;
            burst = 0;
        }
    }

    /**
     * Called often while computing: gives way to others in time.
     *
     * @throws CutOff where nothing more must be computed
     */
    public void breathe() {
        if (turns.areWanted()) {
            hold();
        }
        if (isCutOff) {
            throw new CutOff();
        }
    }

    private void await() {
        boolean interrupted = false;
        while (state == State.WAITING && !isCutOff) {
            LockSupport.parkNanos(turns, Turns.PATIENCE_NANOS);
            interrupted |= Thread.interrupted();
            turns.lend(this);
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** What it does now may take long without giving way. */
    public void heavy() {
        synchronized (turns) {
            heavyTurns = HEAVY_TURNS;
        }
    }

    /** Nothing more is computed, from the next breath on. Any thread may say so. */
    public void cutOff() {
        isCutOff = true;
        wake();
    }

    boolean isCutOff() {
        return isCutOff;
    }

    boolean isRunning() {
        return state == State.RUNNING;
    }

    boolean isWaiting() {
        return state == State.WAITING;
    }

    boolean isHeavy() {
        return heavyTurns > 0;
    }

    /** What it is expected to compute before it rests, or has computed already. */
    long need() {
        return Math.max(usual, burst);
    }

    void computed(long nanos) {
        burst += nanos;
    }

    void begin(long now) {
        since = now;
        state = State.RUNNING;
        countsAsHeavy = isHeavy();
        isBrief = need() < Turns.SHORT_NANOS && !countsAsHeavy;
        heavyTurns -= countsAsHeavy ? 1 : 0;
    }

    void wake() {
        Thread own = thread;
        if (own != null) {
            LockSupport.unpark(own);
        }
    }
}

package robosim.geometry.net.pace;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * The right of one connection to compute, which it takes and gives back. All methods except {@link #cutOff} are called
 * by the connection's own thread.
 */
public final class CpuTurn {
    /** For how many turns a connection counts as heavy after heavy work. */
    private static final int HEAVY_TURNS = 8;

    private final CpuTurns turns;

    /** Whether it must stop computing. */
    private volatile boolean isCutOff;

    private volatile @Nullable Thread thread;

    // The following fields are guarded by the lock of turns.

    enum State {
        IDLE,
        WAITING,
        RUNNING
    }

    volatile State state = State.IDLE;

    /** When it last began to wait, and the sequence number of that wait. */
    long asked;

    long ticket;

    /** When it last began to compute. */
    long since;

    /** The processor time of its thread at that moment, or shortly after; negative until that is known. */
    private volatile long cpuSince = -1;

    boolean isLent;
    boolean isBrief;
    boolean countsAsHeavy;
    private int heavyTurns;

    /** Nanoseconds computed since it last had nothing to do. */
    private long burst;

    /** The average duration of a burst; an assumption for a new connection. */
    private long usual = CpuTurns.SLICE_NANOS;

    CpuTurn(CpuTurns turns) {
        this.turns = turns;
    }

    /** Thrown by {@link #breathe} if a connection must stop computing. */
    public static final class CutOff extends RuntimeException {
        private static final long serialVersionUID = 1;

        public CutOff() {
            this("cut off");
        }

        CutOff(String reason) {
            super(reason, null, false, false);
        }
    }

    /** Waits for the turn. Returns early, without it, if this is cut off. */
    void take() {
        thread = Thread.currentThread();
        turns.ask(this);
        await();
    }

    /** Takes the turn unless it is held already; gives way to others when it is time. */
    void hold() {
        if (state == State.IDLE) {
            take();
        } else if (turns.areWanted()) {
            turns.giveWay(this);
            await();
        }
    }

    /** Gives the turn back for a while. */
    public void give() {
        if (state != State.IDLE) {
            turns.leave(this);
        }
    }

    /** Gives the turn back because there is nothing to do; the next burst starts anew. */
    void rest() {
        synchronized (turns) {
            usual += (burst - usual) / 4;
            burst = 0;
        }
    }

    /** Called often while computing; gives way to others when it is time, and throws if it must stop. */
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
            LockSupport.parkNanos(turns, CpuTurns.PATIENCE_NANOS);
            interrupted |= Thread.interrupted();
            turns.lend(this);
        }
        cpuSince = turns.cpuTime();
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Announces work that may take long without giving way. */
    public void heavy() {
        synchronized (turns) {
            heavyTurns = HEAVY_TURNS;
        }
    }

    /** Stops computing at the next call of {@link #breathe}. May be called by any thread. */
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

    /** The time it is expected to compute before it rests, or has already computed, whichever is more; nanoseconds. */
    long need() {
        return Math.max(usual, burst);
    }

    /**
     * Ends a turn, on its own thread. What counts is the processor time: how long others on the machine have kept the thread
     * waiting says nothing about the connection.
     */
    void computed(long now) {
        long nanos = cpuSince < 0 ? now - since : turns.cpuTime() - cpuSince;
        burst += nanos;
        if (isLent && nanos >= CpuTurns.PATIENCE_NANOS) {
            heavy(); // it did not give way in time
        }
    }

    void begin(long now) {
        since = now;
        cpuSince = -1;
        state = State.RUNNING;
        countsAsHeavy = isHeavy();
        isBrief = need() < CpuTurns.SHORT_NANOS && !countsAsHeavy;
        heavyTurns -= countsAsHeavy ? 1 : 0;
    }

    void wake() {
        Thread own = thread;
        if (own != null) {
            LockSupport.unpark(own);
        }
    }
}

package robosim.geometry.net.pace;

import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * What the request at hand of one connection takes: it ends where that is more than it may, or where its peer has gone. Used by the
 * connection's own thread.
 */
public final class RequestBudget {
    /** The clock is read at one breath in so many. */
    private static final int BREATHS = 4;

    /** How often the processor's time is asked for, which takes longer. */
    private static final long LOOK_NANOS = 5_000_000;

    /** How often it is looked whether the peer is still there; shorter requests are answered in any case. */
    private static final long PEER_NANOS = 100_000_000;

    private final CpuTurn turn;
    private final long most;
    private final BooleanSupplier isGone;
    private final LongSupplier cpu;
    private int breaths;
    private long began;
    private long looked;
    private long lookedForPeer;

    /** Thrown by {@link #breathe} where a request has taken more time than it may. */
    public static final class Overtime extends RuntimeException {
        private static final long serialVersionUID = 1;

        private Overtime(long most) {
            super(
                    "a request must take at most " + most / 1_000_000 + " ms of processor time (got: more)",
                    null,
                    false,
                    false);
        }
    }

    /**
     * An effort that is limited.
     *
     * @param most   nanoseconds of processor time that a request may take
     * @param isGone whether the peer has ended the connection
     */
    public RequestBudget(CpuTurn turn, long most, BooleanSupplier isGone) {
        this(turn, most, isGone, CpuTurns.ofThread());
    }

    RequestBudget(CpuTurn turn, long most, BooleanSupplier isGone, LongSupplier cpu) {
        this.turn = turn;
        this.most = most;
        this.isGone = isGone;
        this.cpu = cpu;
    }

    /** Takes the turn and begins a request. */
    public void begin() {
        turn.hold();
        began = cpu.getAsLong();
        breaths = 0;
        looked = System.nanoTime();
        lookedForPeer = looked;
    }

    /**
     * Called often during a request; gives way to others when it is time.
     *
     * @throws Overtime       if it has taken too much time
     * @throws CpuTurn.CutOff if it must end for another reason
     */
    public void breathe() {
        turn.breathe();
        if (++breaths % BREATHS == 0) {
            look(System.nanoTime());
        }
    }

    private void look(long now) {
        if (now - looked < LOOK_NANOS) {
            return;
        }
        looked = now;
        long taken = cpu.getAsLong() - began;
        if (taken > most) {
            throw new Overtime(most);
        }
        if (taken >= PEER_NANOS && now - lookedForPeer >= PEER_NANOS) {
            if (isGone.getAsBoolean()) {
                throw new CpuTurn.CutOff("its work was cancelled, as the peer has gone");
            }
            lookedForPeer = System.nanoTime();
        }
    }
}

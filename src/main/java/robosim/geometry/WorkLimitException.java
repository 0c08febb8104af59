package robosim.geometry;

import java.io.Serial;

/** Thrown by a call that would exceed its {@link WorkLimit}, or was cancelled. The world is as it was before the call. */
public final class WorkLimitException extends RuntimeException {
    @Serial
    private static final long serialVersionUID = 1;

    private final boolean isCancelled;

    WorkLimitException(String message, boolean isCancelled) {
        super(message);
        this.isCancelled = isCancelled;
    }

    /** Whether the call was cancelled; else it would have taken more units than it may. */
    public boolean isCancelled() {
        return isCancelled;
    }
}

package robosim.geometry.sweep;

import java.io.IOException;

/** A file of results that cannot be used, with its name, the number of the line and why. */
public final class SweepException extends IOException {
    private static final long serialVersionUID = 1;

    SweepException(String message) {
        super(message);
    }

    SweepException(String message, Throwable cause) {
        super(message, cause);
    }
}

package robosim.geometry.cli.terminal;

import org.jspecify.annotations.Nullable;

/** A command cannot use its arguments. The message names the argument, its value and the remedy. */
public final class UsageException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public UsageException(@Nullable String message) {
        this(message, null);
    }

    public UsageException(@Nullable String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}

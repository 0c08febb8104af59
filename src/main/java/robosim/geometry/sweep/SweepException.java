package robosim.geometry.sweep;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** A file of results that cannot be used, with its name, the number of the line and why. */
public final class SweepException extends IOException {
    private static final long serialVersionUID = 1;

    SweepException(String message) {
        super(message);
    }

    SweepException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }

    /** A failure that names its file: what a full disk says does not. */
    static IOException on(Path file, IOException failure) {
        return failure instanceof SweepException || failure instanceof FileSystemException
                ? failure
                : new SweepException(file + ": " + failure.getMessage(), failure);
    }
}

package robosim.geometry.sweep;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** A file of results cannot be used; names the file, the line and the reason. */
final class SweepException extends IOException {
    private static final long serialVersionUID = 1;

    SweepException(String message) {
        super(message);
    }

    SweepException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }

    /** A failure with the file's name, which the message of a full disk lacks. */
    static IOException on(Path file, IOException failure) {
        return failure instanceof SweepException || failure instanceof FileSystemException
                ? failure
                : new SweepException(file + ": " + failure.getMessage(), failure);
    }
}

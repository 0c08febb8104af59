package robosim.geometry.cli.terminal;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;

/** What a failure tells people. */
public final class FailureText {
    private FailureText() {}

    /** Its message, where that is a sentence. */
    public static String of(Exception failure) {
        String message = failure.getMessage();
        if (failure instanceof FileSystemException onFiles && message != null) {
            return file(onFiles, message);
        }
        return message == null ? failure.toString() : message;
    }

    private static String file(FileSystemException failure, String message) {
        String file = String.valueOf(failure.getFile());
        if (failure instanceof NoSuchFileException) {
            return file + ": no such file or folder; check the path";
        }
        if (failure instanceof AccessDeniedException) {
            return file + ": permission denied; check who owns it";
        }
        if (failure instanceof FileAlreadyExistsException) {
            return file + ": already exists and is not a folder; remove it or name another place";
        }
        return failure.getReason() == null ? message : file + ": " + failure.getReason();
    }
}

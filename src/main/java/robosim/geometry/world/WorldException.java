package robosim.geometry.world;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** A world file could not be read or written; names the file, line and column, and what to do about it. */
public final class WorldException extends IOException {
    private static final long serialVersionUID = 1;

    private final String source;
    private final int line;
    private final int column;

    WorldException(String source, int line, int column, String problem, @Nullable Throwable cause) {
        super(place(source, line, column) + problem, cause);
        this.source = source;
        this.line = line;
        this.column = column;
    }

    WorldException(String source, int line, int column, String problem) {
        this(source, line, column, problem, null);
    }

    /** The exception for a file that could not be read: the failure itself if it already says what is wrong. */
    static WorldException unreadable(Path file, IOException failure) {
        if (failure instanceof WorldException told) {
            return told;
        }
        String problem = failure instanceof NoSuchFileException
                ? "there is no such file; check the path"
                : "the file could not be read: " + failure;
        return new WorldException(file.toString(), 0, 0, problem, failure);
    }

    private static String place(String source, int line, int column) {
        if (line < 1) {
            return source + ": ";
        }
        return column < 1 ? source + ":" + line + ": " : source + ":" + line + ":" + column + ": ";
    }

    /** The file, or the name that the reader was given for it. */
    public String source() {
        return source;
    }

    /** The line, from 1; 0 if the problem concerns no line. */
    public int line() {
        return line;
    }

    /** The column, from 1, at the end of the tag or number in question; 0 if the problem concerns no column. */
    public int column() {
        return column;
    }
}

package robosim.geometry.world;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** Says why a file of a world could not be read or written: the file, the line and column, and what to do about it. */
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

    /** The failure of a file that could not be read: as it is, where it already says what is wrong. */
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

    /** The file, or whatever name the reader was given for it. */
    public String source() {
        return source;
    }

    /** The line, counted from 1; 0 where the problem has none. */
    public int line() {
        return line;
    }

    /** The column, counted from 1, at the end of the tag or number in question; 0 where the problem has none. */
    public int column() {
        return column;
    }
}

package robosim.geometry.world.shared;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** What is wrong with a file, where, and the remedy; users get it as a {@code WorldException}. */
public class FileProblem extends IOException {
    private static final long serialVersionUID = 1;

    private final String source;
    private final int line;
    private final int column;
    private final String problem;

    /**
     * A problem at a place in a file.
     *
     * @param line   counted from 1; 0 if the problem concerns no line
     * @param column counted from 1; 0 if the problem concerns no column
     */
    public FileProblem(String source, int line, int column, String problem, @Nullable Throwable cause) {
        super(place(source, line, column) + problem, cause);
        this.source = source;
        this.line = line;
        this.column = column;
        this.problem = problem;
    }

    /** A problem of a whole file. */
    public FileProblem(String source, String problem, @Nullable Throwable cause) {
        this(source, 0, 0, problem, cause);
    }

    /** A problem of a whole file, without a cause. */
    public FileProblem(String source, String problem) {
        this(source, 0, 0, problem, null);
    }

    /** A problem without a cause. */
    public FileProblem(String source, int line, int column, String problem) {
        this(source, line, column, problem, null);
    }

    /** The exception for a file that could not be read: the failure itself if it already says what is wrong. */
    public static FileProblem unreadable(Path file, IOException failure) {
        if (failure instanceof FileProblem told) {
            return told;
        }
        String problem = failure instanceof NoSuchFileException
                ? "there is no such file; check the path"
                : "the file could not be read: " + failure;
        return new FileProblem(file.toString(), problem, failure);
    }

    private static String place(String source, int line, int column) {
        if (line < 1) {
            return source + ": ";
        }
        return column < 1 ? source + ":" + line + ": " : source + ":" + line + ":" + column + ": ";
    }

    /** What is wrong, without the place. */
    public final String problem() {
        return problem;
    }

    public final String source() {
        return source;
    }

    public final int line() {
        return line;
    }

    public final int column() {
        return column;
    }
}

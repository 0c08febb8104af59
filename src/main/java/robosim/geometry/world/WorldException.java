package robosim.geometry.world;

import java.io.IOException;
import robosim.geometry.world.shared.FileProblem;

/** Says why a file of a world could not be read or written: the file, the line and column, and what to do about it. */
public final class WorldException extends IOException {
    private static final long serialVersionUID = 1;

    private final String source;
    private final int line;
    private final int column;

    WorldException(FileProblem problem) {
        super(problem.getMessage(), problem);
        this.source = problem.source();
        this.line = problem.line();
        this.column = problem.column();
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

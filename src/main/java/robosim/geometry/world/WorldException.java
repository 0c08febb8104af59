package robosim.geometry.world;

import java.io.IOException;
import robosim.geometry.world.shared.FileProblem;

/** A world file could not be read or written; names the file, line and column, and the remedy. */
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

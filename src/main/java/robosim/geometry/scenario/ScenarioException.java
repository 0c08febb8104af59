package robosim.geometry.scenario;

import java.io.IOException;
import java.io.Serial;
import org.jspecify.annotations.Nullable;

/** A scenario could not be read; names the file, the line, and what is wrong there. */
public final class ScenarioException extends IOException {
    @Serial
    private static final long serialVersionUID = 1;

    private final String source;
    private final long line;

    ScenarioException(String source, long line, String problem, @Nullable Throwable cause) {
        super(line < 1 ? source + ": " + problem : source + ":" + line + ": " + problem, cause);
        this.source = source;
        this.line = line;
    }

    /** The file, or the name that the reader was given for it. */
    public String source() {
        return source;
    }

    /** The line, from 1; 0 if the problem concerns no line. */
    public long line() {
        return line;
    }
}

package robosim.geometry.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;

/** What tests of commands begin with: an empty folder, and what the last command said. */
public abstract class CommandRun {
    @TempDir
    public Path folder;

    public final StringWriter out = new StringWriter();
    public final StringWriter err = new StringWriter();

    /** Carries a command line out and answers its exit code. */
    final int run(Object... arguments) {
        String[] line = new String[arguments.length];
        for (int k = 0; k < line.length; k++) {
            line[k] = arguments[k].toString();
        }
        out.getBuffer().setLength(0);
        err.getBuffer().setLength(0);
        return Commands.run(new PrintWriter(out, true), new PrintWriter(err, true), line);
    }
}

package robosim.geometry.sweep.lines;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Appends complete lines from many threads at once; after a line that could not be written completely, no more are
 * written.
 */
public final class SweepLines {
    private final OutputStream out;
    private boolean isBroken;

    public SweepLines(OutputStream out) {
        this.out = out;
    }

    /** Appends a line; returns false if an earlier one could not be written. */
    public synchronized boolean append(String line) throws IOException {
        if (isBroken) {
            return false;
        }
        isBroken = true;
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        isBroken = false;
        return true;
    }
}

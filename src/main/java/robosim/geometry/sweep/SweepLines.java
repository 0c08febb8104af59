package robosim.geometry.sweep;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Appends complete lines from many threads at once; after a line that could not be written completely, no more are
 * written.
 */
final class SweepLines {
    private final OutputStream out;
    private boolean isBroken;

    SweepLines(OutputStream out) {
        this.out = out;
    }

    /** Appends a line; returns false if an earlier one could not be written. */
    synchronized boolean append(String line) throws IOException {
        if (isBroken) {
            return false;
        }
        isBroken = true;
        out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
        isBroken = false;
        return true;
    }
}

package robosim.geometry.sweep.lines;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Appends lines, from many threads at once, each whole: where one could not be written, none follows its first half. */
public final class SweepLines {
    private final OutputStream out;
    private boolean isBroken;

    public SweepLines(OutputStream out) {
        this.out = out;
    }

    /** Whether the line stands there now; false where an earlier one could not be written. */
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

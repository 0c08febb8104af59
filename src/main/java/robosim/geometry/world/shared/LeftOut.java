package robosim.geometry.world.shared;

/**
 * A part of a file for which no object was created, though it may be solid.
 *
 * @param source the file that contains it
 * @param line   its line, counted from 1
 * @param what   what it is, by its name in the file
 * @param reason why, and the remedy
 */
public record LeftOut(String source, int line, String what, String reason) {
    /** As a message: file, line, name and reason. */
    @Override
    public String toString() {
        return source + (line < 1 ? "" : ":" + line) + ": left out " + what + ": " + reason;
    }
}

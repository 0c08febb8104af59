package robosim.geometry.world.sdf;

/**
 * Something of a file that no object was made of, though it may be solid.
 *
 * @param source the file that holds it
 * @param line   its line, counted from 1
 * @param what   what it is, by the name that the file gives it
 * @param reason why, and what can be done about it
 */
public record LeftOut(String source, int line, String what, String reason) {
    /** As a message: file, line, what and why. */
    @Override
    public String toString() {
        return source + (line < 1 ? "" : ":" + line) + ": left out " + what + ": " + reason;
    }
}

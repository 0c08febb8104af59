package robosim.geometry.world;

import robosim.geometry.world.sdf.LeftOut;

/**
 * Something of a file that is not in the world that was made of it, though it may matter to it.
 *
 * @param source the file that holds it
 * @param line   its line, counted from 1; 0 where it has none
 * @param what   what it is, by the name that the file gives it
 * @param reason why it was left out, and what can be done about it
 */
public record Skipped(String source, int line, String what, String reason) {
    /** As a message: file, line, what and why. */
    @Override
    public String toString() {
        return new LeftOut(source, line, what, reason).toString();
    }
}

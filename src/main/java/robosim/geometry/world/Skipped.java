package robosim.geometry.world;

import robosim.geometry.world.shared.LeftOut;

/**
 * A part of a file that was left out of the world although it may be relevant.
 *
 * @param source the file that contains it
 * @param line   its line, from 1; 0 if it has none
 * @param what   what it is, by its name in the file
 * @param reason why it was left out, and what can be done about it
 */
public record Skipped(String source, int line, String what, String reason) {
    static Skipped of(LeftOut each) {
        return new Skipped(each.source(), each.line(), each.what(), each.reason());
    }

    /** As a message: file, line, what and why. */
    @Override
    public String toString() {
        return new LeftOut(source, line, what, reason).toString();
    }
}

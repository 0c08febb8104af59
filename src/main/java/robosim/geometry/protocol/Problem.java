package robosim.geometry.protocol;

import java.util.Objects;
import java.util.function.Supplier;
import robosim.geometry.check.Checks;

/**
 * Why one request of a bundle was refused, in human-readable text. The text is created on demand, so an encoding that
 * does not show it does not pay for it.
 */
public final class Problem {
    private final int index;
    private final Supplier<String> words;

    private Problem(int index, Supplier<String> words) {
        if (index < 0) {
            throw new IllegalArgumentException("index must be at least 0 (got: " + index + ")");
        }
        this.index = index;
        this.words = words;
    }

    /** A problem with a given text. */
    public static Problem of(int index, String reason) {
        Checks.present("reason", reason);
        return new Problem(index, () -> reason);
    }

    /**
     * A problem whose text is created on demand.
     *
     * @param index  index of the request in its bundle
     * @param reason must give the same text each time, on any thread
     */
    public static Problem of(int index, Supplier<String> reason) {
        return new Problem(index, Checks.present("reason", reason));
    }

    /** The index of the refused request in its bundle, from 0. */
    public int index() {
        return index;
    }

    /** The reason, as in {@code blocked by "wall 3" after 0.25 of the way}. */
    public String reason() {
        return words.get();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Problem that && index == that.index && reason().equals(that.reason());
    }

    @Override
    public int hashCode() {
        return Objects.hash(index, reason());
    }

    @Override
    public String toString() {
        return index + ": " + reason();
    }
}

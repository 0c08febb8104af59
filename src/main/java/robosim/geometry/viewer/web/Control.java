package robosim.geometry.viewer.web;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** What a page may change. Its methods are called by the threads of the server, at the same time. */
public interface Control {
    /** The names of the commands that there are, for the page's buttons. */
    List<String> commands();

    /**
     * Carries out a command.
     *
     * @param command {@code do} is its name
     * @return what came of it, as text for people; empty if it was carried out
     * @throws IllegalArgumentException for one that is wrong
     */
    String carryOut(Map<?, ?> command) throws InterruptedException;

    /** What the page shows about it: field names and values. */
    Map<String, @Nullable Object> state();

    /** A text of a command. */
    static String text(Map<?, ?> command, String field) {
        if (command.get(field) instanceof String text) {
            return text;
        }
        throw new IllegalArgumentException(field + " must be a text (got: " + command.get(field) + ")");
    }

    /** A finite number of a command. */
    static double number(Map<?, ?> command, String field) {
        if (command.get(field) instanceof Number number && Double.isFinite(number.doubleValue())) {
            return number.doubleValue();
        }
        throw new IllegalArgumentException(field + " must be a finite number (got: " + command.get(field) + ")");
    }
}

package robosim.geometry.docs;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A block of code in a page or in javadoc.
 *
 * @param page     the file
 * @param line     of its first line of code, from 1
 * @param language what a page calls it; {@code java} in javadoc
 * @param marker   what a comment {@code <!-- java: ... -->} above it says: words between semicolons; empty where there is none
 */
public record Block(String page, int line, String language, String marker, String code) {
    String place() {
        return page + ":" + line;
    }

    /** {@code continues}: it goes on where the block before it on its page ended. */
    boolean continues() {
        return words().contains("continues");
    }

    /** {@code compiled}: it is not run, since it wants a file or a peer that is not here. */
    boolean isOnlyCompiled() {
        return words().contains("compiled") || given().isPresent();
    }

    /** {@code given TYPE NAME, TYPE NAME}: variables that it takes for granted; so it is not run. */
    Optional<String> given() {
        return words().stream()
                .filter(word -> word.startsWith("given "))
                .map(word -> word.substring("given ".length()))
                .findFirst();
    }

    private List<String> words() {
        return Arrays.stream(marker.split(";")).map(String::strip).toList();
    }
}

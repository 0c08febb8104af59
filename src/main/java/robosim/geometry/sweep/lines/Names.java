package robosim.geometry.sweep.lines;

import java.nio.file.Path;

/** What worlds, parameters and their values may be called: words that stand beside each other in a line. */
public final class Names {
    public static final int MOST = 200;

    private Names() {}

    public static String check(String what, String name) {
        if (name == null || !name.matches("[^\\s,/\\p{Cntrl}]{1," + MOST + "}") || hasHalf(name)) {
            throw new IllegalArgumentException(what + " must be 1 to " + MOST
                    + " characters without blanks, commas and slashes (got: " + name + ")");
        }
        return name;
    }

    /** Whether a text has half of a surrogate pair, which UTF-8 cannot hold. */
    public static boolean hasHalf(String text) {
        return text.codePoints().anyMatch(c -> c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE);
    }

    /** A file's name up to its first point. */
    public static String of(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int end = name.indexOf('.', 1);
        return (end < 0 ? name : name.substring(0, end)).replaceAll("[\\s,]", "-");
    }
}

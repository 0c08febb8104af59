package robosim.geometry.sweep.lines;

import java.nio.file.Path;

/** Checks the names of worlds and parameters and the values of parameters: words that can be listed in a line. */
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

    /** Whether a string has an unpaired surrogate, which UTF-8 cannot represent. */
    public static boolean hasHalf(String text) {
        return text.codePoints().anyMatch(c -> c >= Character.MIN_SURROGATE && c <= Character.MAX_SURROGATE);
    }

    /** A file's name up to its first dot, as a valid name. */
    public static String of(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int end = name.indexOf('.', 1);
        return (end < 0 ? name : name.substring(0, end)).replaceAll("[\\s,]", "-");
    }
}

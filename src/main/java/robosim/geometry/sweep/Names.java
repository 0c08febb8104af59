package robosim.geometry.sweep;

import java.nio.file.Path;

/** What worlds, parameters and their values may be called: words that stand beside each other in a line. */
final class Names {
    private Names() {}

    static String check(String what, String name) {
        if (name == null || !name.matches("[^\\s,/\\p{Cntrl}]{1,200}")) {
            throw new IllegalArgumentException(
                    what + " must be 1 to 200 characters without blanks, commas and slashes (got: " + name + ")");
        }
        return name;
    }

    /** A file's name up to its first point. */
    static String of(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int end = name.indexOf('.', 1);
        return (end < 0 ? name : name.substring(0, end)).replaceAll("[\\s,]", "-");
    }
}

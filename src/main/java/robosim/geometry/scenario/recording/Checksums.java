package robosim.geometry.scenario.recording;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.zip.CRC32;

/**
 * The checksums of a recording's lines: the last field of each, {@code "crc"}, eight hexadecimal digits. It is the CRC-32 of
 * the digits of the line before, none for the first, and then of the bytes of the line without that field, in UTF-8. So it
 * tells a line that was altered, and lines that are missing before it.
 */
public final class Checksums {
    private static final String BEGIN = ",\"crc\":\"";
    private static final String END = "\"}";
    private static final int DIGITS = 8;

    /** The number of characters that a checksum adds to a line. */
    public static final int LENGTH = BEGIN.length() + DIGITS + END.length() - 1;

    private String last = "";

    /** For the first line. */
    public Checksums() {}

    /** A line, which is an object that is not empty, with its checksum. */
    public String seal(String line) {
        last = digits(line);
        return line.substring(0, line.length() - 1) + BEGIN + last + END;
    }

    public static boolean isSealed(String line) {
        return line.endsWith(END) && line.startsWith(BEGIN, line.length() - LENGTH - 1);
    }

    /** A sealed line without its checksum. */
    public static String open(String line) {
        return line.substring(0, line.length() - LENGTH - 1) + "}";
    }

    /** Whether a line is as it was sealed, and after the same one. The next one is expected to follow it in any case. */
    public boolean isRight(String line) {
        if (!isSealed(line)) {
            return false;
        }
        String stated = line.substring(line.length() - DIGITS - END.length(), line.length() - END.length());
        boolean isRight = stated.equals(digits(open(line)));
        last = stated;
        return isRight;
    }

    /** What {@link #restore} takes to forget the lines sealed since. */
    public String state() {
        return last;
    }

    /** Goes back to an earlier {@link #state}: the lines sealed since were not written. */
    public void restore(String state) {
        last = state;
    }

    private String digits(String line) {
        CRC32 sum = new CRC32();
        sum.update(last.getBytes(StandardCharsets.UTF_8));
        sum.update(line.getBytes(StandardCharsets.UTF_8));
        return String.format(Locale.ROOT, "%08x", sum.getValue());
    }
}

package robosim.geometry.sweep.lines;

import java.nio.charset.StandardCharsets;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;

/** Lines with a checksum as their last field: the CRC-32C of everything before it. */
public final class ChecksummedLine {
    private static final String FIELD = ",\"check\":\"";
    private static final String FORM = "[0-9a-f]{8}\"}";

    private ChecksummedLine() {}

    /** Adds the checksum to the line of an object. */
    public static String seal(String line) {
        String open = line.substring(0, line.length() - 1);
        return open + FIELD + check(open) + "\"}";
    }

    /** Removes the checksum; returns null if the line has none, or has been altered. */
    public static @Nullable String open(String sealed) {
        int at = sealed.lastIndexOf(FIELD);
        if (at < 0) {
            return null;
        }
        String open = sealed.substring(0, at);
        String rest = sealed.substring(at + FIELD.length());
        return rest.matches(FORM) && rest.startsWith(check(open)) ? open + "}" : null;
    }

    private static String check(String text) {
        CRC32C sum = new CRC32C();
        sum.update(text.getBytes(StandardCharsets.UTF_8));
        return String.format("%08x", sum.getValue());
    }
}

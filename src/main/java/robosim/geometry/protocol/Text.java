package robosim.geometry.protocol;

import java.util.HexFormat;
import robosim.geometry.exact.Checks;

/** Makes text from a peer safe for a line of a log. */
public final class Text {
    private static final int LONGEST_QUOTE = 100;
    private static final int LONGEST_LINE = 500;

    private Text() {}

    /** A name in quotes, on one line, shortened if necessary. */
    public static String quoted(String name) {
        return '"'
                + plain(Checks.present("name", name).replace("\\", "\\\\").replace("\"", "\\\""), LONGEST_QUOTE)
                + '"';
    }

    /** A sentence that may contain text from a peer, on one line, shortened if necessary. */
    public static String line(String sentence) {
        return plain(Checks.present("sentence", sentence), LONGEST_LINE);
    }

    private static String plain(String text, int longest) {
        StringBuilder plain = new StringBuilder();
        for (int k = 0; k < Math.min(text.length(), longest); k++) {
            char c = text.charAt(k);
            if (isPlain(c)) {
                plain.append(c);
            } else {
                plain.append("\\u").append(HexFormat.of().toHexDigits(c));
            }
        }
        return plain.append(text.length() > longest ? "..." : "").toString();
    }

    // Control characters, direction marks and unpaired surrogates could forge or garble a line.
    private static boolean isPlain(char c) {
        return switch (Character.getType(c)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR,
                    Character.UNASSIGNED -> false;
            default -> true;
        };
    }
}

package robosim.geometry.check;

import java.util.Collection;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;

/** Makes text from a peer safe for a line of a log, and suggests names. */
public final class Text {
    private static final int LONGEST_QUOTE = 100;
    private static final int LONGEST_LINE = 500;

    /** Names that are listed in full. */
    private static final int FEW = 8;

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

    /**
     * What a name could have been, for the refusal of one that does not exist: {@code one of ["a", "b"]}, or of many the
     * closest, or the first ones if none is close.
     */
    public static String choice(String given, Collection<String> names) {
        Checks.present("given", given);
        Checks.present("names", names);
        if (names.isEmpty()) {
            return "of which there are none";
        }
        if (names.size() <= FEW) {
            return "one of [" + list(names) + "]";
        }
        List<String> near = NearNames.of(given, names);
        return near.isEmpty()
                ? "one of " + NumberText.count(names.size(), "name") + " such as "
                        + list(names.stream().limit(FEW / 2).toList())
                : "one of " + NumberText.count(names.size(), "name") + ", the closest of which "
                        + (near.size() == 1 ? "is " : "are ") + list(near);
    }

    /** The closest names to one that does not exist, to be appended: {@code ; closest: "a", "b"}, or nothing. */
    public static String closest(String given, Iterable<String> names) {
        List<String> near = NearNames.of(Checks.present("given", given), Checks.present("names", names));
        return near.isEmpty() ? "" : "; closest: " + list(near);
    }

    private static String list(Collection<String> names) {
        return names.stream().map(Text::quoted).collect(Collectors.joining(", "));
    }

    /** Text escaped for XML; characters that XML does not allow become U+FFFD. */
    public static String xml(String text) {
        StringBuilder escaped = new StringBuilder(Checks.present("text", text).length());
        text.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> escaped.append("&amp;");
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                default -> escaped.appendCodePoint(isXml(c) ? c : 0xfffd);
            }
        });
        return escaped.toString();
    }

    private static boolean isXml(int c) {
        return c == '\t' || (c >= ' ' && c < 0xd800) || (c >= 0xe000 && c <= 0xfffd) || c >= 0x10000;
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

package robosim.geometry.world.shared;

import java.nio.charset.StandardCharsets;

/** Words between white space in the bytes of a file, with the line on which each stands. */
public final class AsciiScanner {
    private final byte[] bytes;
    private final String source;
    private final int comment;
    private int from;
    private int to;
    private int line = 1;

    /**
     * A comment mark ends a word and hides the rest of its line, to the next line feed or carriage return; -1 where the
     * format has no comments.
     */
    public AsciiScanner(byte[] bytes, String source, int comment) {
        this.bytes = bytes;
        this.source = source;
        this.comment = comment;
    }

    /** Goes to the next word; false at the end. */
    public boolean next() {
        while (to < bytes.length && (isSpace(bytes[to]) || bytes[to] == comment)) {
            if (bytes[to] == comment) {
                skipComment();
            } else {
                line += bytes[to] == '\n' ? 1 : 0;
                to++;
            }
        }
        from = to;
        while (to < bytes.length && !isSpace(bytes[to]) && bytes[to] != comment) {
            to++;
        }
        return from < to;
    }

    private void skipComment() {
        while (to < bytes.length && bytes[to] != '\n' && bytes[to] != '\r') {
            to++;
        }
    }

    private static boolean isSpace(byte b) {
        return b == ' ' || (b >= '\t' && b <= '\r');
    }

    /** The current word; empty at the end. */
    public String word() {
        return new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
    }

    /** Whether the current word is this one, in capitals or not. */
    public boolean is(String word) {
        return to - from == word.length() && word().equalsIgnoreCase(word);
    }

    /** Passes over the rest of the line. */
    public void skipLine() {
        while (to < bytes.length && bytes[to] != '\n') {
            to++;
        }
    }

    /** Where the bytes begin behind the current word: after the one white space, or the comment, that ends it. */
    public int behind() {
        if (to < bytes.length && bytes[to] == comment) {
            skipComment();
        }
        return Math.min(to, bytes.length) + 1;
    }

    /** Goes to the next word, which is one of these; answers which. */
    public int expect(String what, String... words) throws FileProblem {
        next();
        for (int k = 0; k < words.length; k++) {
            if (is(words[k])) {
                return k;
            }
        }
        throw missing(what);
    }

    /** The current word is this one; always true. */
    public boolean expectCurrent(String what, String word) throws FileProblem {
        if (is(word)) {
            return true;
        }
        throw missing(what);
    }

    /** Goes to the next word, whatever it is. */
    public void any(String what) throws FileProblem {
        if (!next()) {
            throw missing(what);
        }
    }

    /** Goes to the next word, a number. */
    public double number(String what) throws FileProblem {
        any(what);
        try {
            if (to - from > Numbers.MAX_LENGTH) {
                throw new IllegalArgumentException(
                        "a number must have at most " + Numbers.MAX_LENGTH + " characters (got: " + (to - from) + ")");
            }
            return Numbers.parse(word());
        } catch (IllegalArgumentException e) {
            throw wrong(what + ": " + e.getMessage());
        }
    }

    /** Goes to the next word, digits of a number from a least one to a most one. */
    public int digits(String what, int least, int most) throws FileProblem {
        any(what);
        int value = 0;
        boolean fits = to - from <= 9;
        for (int k = from; fits && k < to; k++) {
            fits = bytes[k] >= '0' && bytes[k] <= '9';
            value = 10 * value + (bytes[k] - '0');
        }
        if (!fits || value < least || value > most) {
            throw wrong(what + " must be a whole number from " + least + " to " + most + " (got: " + shown() + ")");
        }
        return value;
    }

    public FileProblem wrong(String problem) {
        return new FileProblem(source, line, 0, problem);
    }

    private FileProblem missing(String what) {
        return wrong("here must stand " + what + " (got: " + (from < to ? shown() : "the end of the file") + ")");
    }

    private String shown() {
        String text = new String(bytes, from, Math.min(to - from, 40), StandardCharsets.US_ASCII);
        return to - from > 40 ? text + "..." : text;
    }
}

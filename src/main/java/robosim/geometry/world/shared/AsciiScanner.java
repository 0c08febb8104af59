package robosim.geometry.world.shared;

import java.nio.charset.StandardCharsets;

/** Splits the bytes of a file into words at white space, and records the line of each. */
public final class AsciiScanner {
    private final byte[] bytes;
    private final String source;
    private final int comment;
    private int from;
    private int to;
    private int line = 1;

    /**
     * Takes the character that begins a comment, which ends a word and hides the rest of the line up to the next line
     * feed or carriage return; -1 if the format has no comments.
     */
    public AsciiScanner(byte[] bytes, String source, int comment) {
        this.bytes = bytes;
        this.source = source;
        this.comment = comment;
    }

    /**
     * Begins in the middle of a file.
     *
     * @param from the index of the first byte
     * @param line its line, counted from 1
     */
    public AsciiScanner(byte[] bytes, String source, int from, int line) {
        this(bytes, source, -1);
        this.to = from;
        this.line = line;
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

    /** Whether the current word is this one, ignoring case. */
    public boolean is(String word) {
        return to - from == word.length() && word().equalsIgnoreCase(word);
    }

    /** Skips the rest of the line and answers it, without white space at its ends. */
    public String restOfLine() {
        int begin = to;
        skipLine();
        return new String(bytes, begin, to - begin, StandardCharsets.ISO_8859_1).strip();
    }

    /** Skips the rest of the line. */
    public void skipLine() {
        while (to < bytes.length && bytes[to] != '\n') {
            to++;
        }
    }

    /** The index of the bytes after the current word: after the single white space, or the comment, that ends it. */
    public int behind() {
        if (to < bytes.length && bytes[to] == comment) {
            skipComment();
        }
        return Math.min(to, bytes.length) + 1;
    }

    /** Goes to the next word, which must be one of these; returns its index among them. */
    public int expect(String what, String... words) throws FileProblem {
        next();
        for (int k = 0; k < words.length; k++) {
            if (is(words[k])) {
                return k;
            }
        }
        throw missing(what);
    }

    /** Checks that the current word is this one; always returns true. */
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

    /** Goes to the next word, which must be a number. */
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

    /** Goes to the next word, which must be the digits of a number from {@code least} to {@code most}. */
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
        return wrong(what + " must come next (got: " + (from < to ? shown() : "the end of the file") + ")");
    }

    private String shown() {
        String text = new String(bytes, from, Math.min(to - from, 40), StandardCharsets.US_ASCII);
        return to - from > 40 ? text + "..." : text;
    }
}

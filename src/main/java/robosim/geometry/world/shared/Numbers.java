package robosim.geometry.world.shared;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Parses numbers: decimal and finite ones, and nothing else that Java would accept. */
public final class Numbers {
    /** A double has at most 24 characters; longer exact decimals are allowed up to this length. */
    static final int MAX_LENGTH = 100;

    private Numbers() {}

    /** The words of a text, separated by white space; one empty word if it has none. */
    public static String[] words(String text) {
        String all = text.strip();
        List<String> words = new ArrayList<>();
        int from = 0;
        for (int k = 0; k < all.length(); k++) {
            if (isSpace(all.charAt(k))) {
                if (k > from) {
                    words.add(all.substring(from, k));
                }
                from = k + 1;
            }
        }
        words.add(all.substring(from));
        return words.toArray(new String[0]);
    }

    /** A regular expression's {@code \\s}, which takes several times as long. */
    private static boolean isSpace(char c) {
        return c == ' ' || (c >= '\t' && c <= '\r');
    }

    /** A number; the message of the exception says what is required and what was given. */
    public static double parse(String token) {
        if (isDecimal(token)) {
            try {
                double value = Double.parseDouble(token);
                if (Double.isFinite(value)) {
                    return value;
                }
            } catch (NumberFormatException e) {
                throw wrong(token, e);
            }
        }
        throw wrong(token, null);
    }

    /** An index in XML: from 0. */
    public static int index(String token) {
        int index = integer(token, " of at least 0");
        if (index < 0) {
            throw new IllegalArgumentException("an index must be a whole number of at least 0 (got: " + token + ")");
        }
        return index;
    }

    /** A whole number of either sign. */
    public static int integer(String token) {
        return integer(token, "");
    }

    private static int integer(String token, String range) {
        try {
            return Integer.parseInt(token);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    "an index must be a whole number" + range + " (got: " + shown(token) + ")", e);
        }
    }

    private static boolean isDecimal(String token) {
        if (token.length() > MAX_LENGTH) {
            return false;
        }
        int exponentDigits = -1;
        for (int k = 0; k < token.length(); k++) {
            char c = token.charAt(k);
            if (c == 'e' || c == 'E') {
                exponentDigits = 0;
            } else if (c >= '0' && c <= '9') {
                exponentDigits += exponentDigits >= 0 ? 1 : 0;
            } else if (c != '.' && c != '+' && c != '-') {
                return false;
            }
        }
        // No double has an exponent of more digits, and exact arithmetic on it would take long.
        return exponentDigits <= 3;
    }

    private static IllegalArgumentException wrong(String token, @Nullable Throwable cause) {
        return new IllegalArgumentException(
                "a number must be decimal and finite, like 12, -0.5 or 1.5e-3 (got: " + shown(token) + ")", cause);
    }

    /** A token for a message, shortened if it is long. */
    public static String shown(String token) {
        return token.length() <= MAX_LENGTH ? token : token.substring(0, MAX_LENGTH) + "...";
    }
}

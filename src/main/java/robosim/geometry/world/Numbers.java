package robosim.geometry.world;

import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Numbers of a text: decimal, finite, and nothing else that Java would take for a number. */
final class Numbers {
    /** A double is written in at most 24 characters; people who count exactly need some more. */
    static final int MAX_LENGTH = 100;

    private static final Pattern SPACE = Pattern.compile("\\s+");

    private Numbers() {}

    /** The words of a text between white space; one empty word where it has none. */
    static String[] words(String text) {
        return SPACE.split(text.strip(), -1);
    }

    /** A number; the message of the exception says what it must be and what came. */
    static double parse(String token) {
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

    /** A length in world units; it may carry a unit of its own where the world unit is known. */
    static double length(String token, @Nullable Unit worldUnit) {
        if (token.isEmpty() || token.charAt(token.length() - 1) < 'A') { // no letter at its end: the ordinary case
            return parse(token);
        }
        int end = token.length();
        while (end > 0 && Character.isLetter(token.charAt(end - 1))) {
            end--;
        }
        Unit unit = Unit.of(token.substring(end));
        String number = token.substring(0, end);
        if (unit == null) {
            throw new IllegalArgumentException(
                    "a length must be a number, alone or followed by km, m, cm, mm, in or ft (got: " + token + ")");
        }
        double plain = parse(number);
        if (worldUnit == null) {
            throw new IllegalArgumentException(
                    "a length with a unit needs the world's own: add unit=\"m\" to <world>, or leave the unit away (got: "
                            + token + ")");
        }
        return unit == worldUnit ? plain : unit.in(worldUnit, number);
    }

    /** An index as XML has it: from 0. */
    static int index(String token) {
        int index = integer(token, " of at least 0");
        if (index < 0) {
            throw new IllegalArgumentException("an index must be a whole number of at least 0 (got: " + token + ")");
        }
        return index;
    }

    /** A whole number of either sign. */
    static int integer(String token) {
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
        // An exponent of more digits is no double, and exact arithmetic on it would take its time.
        return exponentDigits <= 3;
    }

    private static IllegalArgumentException wrong(String token, @Nullable Throwable cause) {
        return new IllegalArgumentException(
                "a number must be decimal and finite, like 12, -0.5 or 1.5e-3 (got: " + shown(token) + ")", cause);
    }

    private static String shown(String token) {
        return token.length() <= MAX_LENGTH ? token : token.substring(0, MAX_LENGTH) + "...";
    }
}

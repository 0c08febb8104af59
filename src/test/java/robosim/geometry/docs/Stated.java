package robosim.geometry.docs;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.regex.Pattern;

/** The values that comments in code state, as in {@code // 3.9: the wall}. */
public final class Stated {
    /** A value at the beginning of a comment. */
    static final Pattern VALUE =
            Pattern.compile("^[ \\t]*//[ \\t]*(-?\\d[\\d,]*(?:\\.\\d+)?(?:[eE]-?\\d+)?|true|false|null|NaN"
                    + "|[+-]?Infinity|\"[^\"]*\"|[A-Z][A-Z_]+)(?=[:;,.)]?(?:\\s|$))");

    private static int checks;

    private Stated() {}

    /** Fails where a value is not the one that is stated, to as many digits as are stated. */
    public static void check(String place, String stated, Object got) {
        checks++;
        if (!holds(stated, got)) {
            throw new AssertionError(place + ": the comment says " + stated + " (got: " + got + ")");
        }
    }

    /** How many values have been compared. */
    static int checks() {
        return checks;
    }

    private static boolean holds(String stated, Object got) {
        if (got instanceof Double number && Character.isDigit(stated.charAt(stated.length() - 1))) {
            BigDecimal expected = new BigDecimal(stated.replace(",", ""));
            return Double.isFinite(number)
                    && new BigDecimal(number)
                                    .setScale(expected.scale(), RoundingMode.HALF_EVEN)
                                    .compareTo(expected)
                            == 0;
        }
        String text = got instanceof String ? "\"" + got + "\"" : String.valueOf(got);
        return text.equals(stated.replaceFirst("^\\+", "").replaceAll("(?<=\\d),(?=\\d)", ""));
    }
}

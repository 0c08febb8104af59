package robosim.geometry.world;

import java.math.BigDecimal;
import java.math.MathContext;
import org.jspecify.annotations.Nullable;
import robosim.geometry.world.shared.Numbers;

/** A unit of length in a world file: as its world unit, or after single numbers, as in {@code 25cm}. */
public enum Unit {
    KILOMETRE("km", "1000000"),
    METRE("m", "1000"),
    CENTIMETRE("cm", "10"),
    MILLIMETRE("mm", "1"),
    INCH("in", "25.4"),
    FOOT("ft", "304.8");

    private final String symbol;
    private final BigDecimal millimetres;

    Unit(String symbol, String millimetres) {
        this.symbol = symbol;
        this.millimetres = new BigDecimal(millimetres);
    }

    /** The symbol in a file: {@code km}, {@code m}, {@code cm}, {@code mm}, {@code in} or {@code ft}. */
    public String symbol() {
        return symbol;
    }

    /** Its length in metres. */
    public double metres() {
        return millimetres.movePointLeft(3).doubleValue();
    }

    /** The unit of a symbol, or null where there is none. */
    public static @Nullable Unit of(String symbol) {
        for (Unit unit : values()) {
            if (unit.symbol.equals(symbol)) {
                return unit;
            }
        }
        return null;
    }

    /** Converts a decimal number of this unit to another one: the nearest double. */
    double in(Unit other, String decimal) {
        BigDecimal length = new BigDecimal(decimal).multiply(millimetres);
        // Between the decimal units the division terminates; otherwise 60 digits leave no doubt in practice.
        return length.divide(other.millimetres, new MathContext(60 + length.precision()))
                .doubleValue();
    }

    /** A length in world units; it may carry its own unit if the world unit is known. */
    static double length(String token, @Nullable Unit worldUnit) {
        if (token.isEmpty() || token.charAt(token.length() - 1) < 'A') { // no letter at its end: the usual case
            return Numbers.parse(token);
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
        double plain = Numbers.parse(number);
        if (worldUnit == null) {
            throw new IllegalArgumentException(
                    "a length with a unit needs a world with a unit: add unit=\"m\" to <world>, or omit this unit"
                            + " (got: " + token + ")");
        }
        return unit == worldUnit ? plain : unit.in(worldUnit, number);
    }
}

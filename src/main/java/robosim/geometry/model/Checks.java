package robosim.geometry.model;

/** The rules for numbers that come from outside; each message names the argument and its value. */
final class Checks {
    /** The largest coordinate or size: products of three still have room below the overflow. */
    static final double LIMIT = 0x1p100;

    private Checks() {}

    /** A coordinate, with -0.0 made +0.0. */
    static double coordinate(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** A size: at least zero. */
    static double size(String argument, double value) {
        if (!(value >= 0 && value <= LIMIT)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be a number from 0 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** An angle in degrees, of any size. */
    static double angle(String argument, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException(argument + " must be a finite angle in degrees (got: " + degrees + ")");
        }
        return degrees + 0.0;
    }

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    static String name(String value) {
        if (present("name", value).isBlank()) {
            throw new IllegalArgumentException("name must have a visible character (got: \"" + value + "\")");
        }
        return value;
    }
}

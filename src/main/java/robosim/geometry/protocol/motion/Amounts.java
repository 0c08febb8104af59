package robosim.geometry.protocol.motion;

import robosim.geometry.exact.Degrees;

/** Checks of physical quantities; each message names the argument and its value. */
final class Amounts {
    /** The largest quantity; products of three of them with an hour are far from the limit of coordinates, 2^100. */
    private static final double MOST = 1e9;

    /** The least that is not zero; a quotient of two quantities stays within 10^18. */
    private static final double LEAST = 1e-9;

    private Amounts() {}

    static double finite(String argument, double value) {
        if (!(Math.abs(value) <= MOST)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be a number from -10^9 to 10^9 (got: " + value + ")");
        }
        return value + 0.0;
    }

    static double atLeastZero(String argument, double value) {
        if (!(value >= 0 && value <= MOST)) {
            throw new IllegalArgumentException(argument + " must be a number from 0 to 10^9 (got: " + value + ")");
        }
        return value + 0.0;
    }

    static double positive(String argument, double value) {
        if (!(value >= LEAST && value <= MOST)) {
            throw new IllegalArgumentException(argument + " must be a number from 10^-9 to 10^9 (got: " + value + ")");
        }
        return value;
    }

    /** A quantity above zero, or zero where it is to be worked out. */
    static double orDefault(String argument, double value) {
        if (!(value == 0 || (value >= LEAST && value <= MOST))) {
            throw new IllegalArgumentException(
                    argument + " must be a number from 10^-9 to 10^9, or 0 for the default (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** Degrees in radians; infinite for no limit. */
    static double radians(double degrees) {
        return degrees == Double.POSITIVE_INFINITY ? degrees : Degrees.toRadians(degrees);
    }

    /** Radians in degrees; infinite for no limit. */
    static double degrees(double radians) {
        return radians == Double.POSITIVE_INFINITY ? radians : Degrees.toDegrees(radians);
    }

    /** A limit, which may be infinite. */
    static double limit(String argument, double value) {
        if (!(value >= 0 && (value <= MOST || value == Double.POSITIVE_INFINITY))) {
            throw new IllegalArgumentException(
                    argument + " must be a number from 0 to 10^9, or infinite for no limit (got: " + value + ")");
        }
        return value + 0.0;
    }
}

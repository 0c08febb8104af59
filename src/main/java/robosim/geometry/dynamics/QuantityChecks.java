package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.model.Twist;

/** Checks of physical quantities; each message names the argument and its value. */
final class QuantityChecks {
    /** The largest quantity; products of five of them are far from overflow. */
    private static final double MOST = 0x1p100;

    /** By this share one moment may exceed the sum of the other two: those of a thin plate, given in seven digits. */
    private static final double ROUNDING = 1e-6;

    private QuantityChecks() {}

    static double positive(String argument, double value) {
        if (!(value > 0 && value <= MOST)) { // written so that NaN fails it
            throw new IllegalArgumentException(
                    argument + " must be a number above 0 and at most 2^100 (got: " + value + ")");
        }
        return value;
    }

    static double atLeastZero(String argument, double value) {
        if (!(value >= 0 && value <= MOST)) {
            throw new IllegalArgumentException(argument + " must be a number from 0 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    static double finite(String argument, double value) {
        if (!(Math.abs(value) <= MOST)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** A limit, which may be infinite. */
    static double limit(String argument, double value) {
        if (!(value >= 0)) {
            throw new IllegalArgumentException(
                    argument + " must be at least 0; infinite for no limit (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** Refuses principal moments that no body has: each is at most the sum of the other two. */
    static void moments(double x, double y, double z) {
        double most = Math.max(x, Math.max(y, z));
        // The sum of all is at least twice the greatest.
        if (x + y + z < most * (2 - ROUNDING)) {
            throw new IllegalArgumentException(
                    "moments of inertia must each be at most the sum of the other two, as those of"
                            + " every body are (got: " + x + ", " + y + ", " + z + " about X, Y, Z)");
        }
    }

    /** Refuses a part upwards where nothing would come of it. */
    static void level(String argument, Twist velocity, String where) {
        if (velocity.y() != 0) {
            throw new IllegalArgumentException(
                    argument + " must have no part upwards " + where + "; set y to 0 (got: " + velocity + ")");
        }
    }

    static double clamp(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    /** A value after it has gone towards another one by no more than a step. */
    static double toward(double from, double to, double step) {
        return Math.abs(to - from) <= step ? to : from + Math.copySign(step, to - from);
    }

    /** A limit of a change times the length of a step; the limit may be infinite. */
    static double step(double limit, double seconds) {
        return seconds == 0 ? 0 : limit * seconds;
    }

    /** The numbers of a velocity at the beginning of a step, checked as {@link Drive#next} does. */
    static double[] numbers(Twist now, Body body, double seconds) {
        Checks.present("now", now);
        Checks.present("body", body);
        atLeastZero("seconds", seconds);
        return new double[] {now.x(), now.y(), now.z(), now.ry()};
    }

    static Twist twist(double[] v) {
        return new Twist(v[0], v[1], v[2], v[3]);
    }
}

package robosim.geometry.check;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Argument checks; each message names the argument and its value. */
public final class Checks {
    /** The largest coordinate or size; products of three such numbers are far from overflow. */
    public static final double LIMIT = 0x1p100;

    /** The largest number of threads for one question, more than machines have processors. */
    private static final int MOST_THREADS = 1024;

    private Checks() {}

    /** Returns a value unless it is null. */
    public static <T> T present(String argument, @Nullable T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    /** Refuses an argument if something is so; {@code rule} says what it must be. */
    public static void refuse(boolean isSo, String rule, Object got) {
        if (isSo) {
            throw new IllegalArgumentException(rule + " (got: " + got + ")");
        }
    }

    /** An immutable copy of a list, which must not be null or contain null. */
    public static <T> List<T> list(String argument, @Nullable List<? extends @Nullable T> values) {
        int k = 0;
        for (T value : present(argument, values)) {
            present(argument + "[" + k++ + "]", value);
        }
        @SuppressWarnings("unchecked") // no element is null
        List<T> all = (List<T>) values;
        return List.copyOf(all);
    }

    /** Returns a valid coordinate, with -0.0 changed to +0.0. */
    public static double coordinate(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be a number from -2^100 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** Returns a valid size: at least zero. */
    public static double size(String argument, double value) {
        if (!(value >= 0 && value <= LIMIT)) { // written so that NaN fails it
            throw new IllegalArgumentException(argument + " must be a number from 0 to 2^100 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /**
     * Returns a valid size whose half is a double: it is the size itself, except that below 2<sup>-1021</sup> it is rounded to a
     * multiple of 2<sup>-1073</sup>.
     */
    public static double halved(String argument, double value) {
        return 2 * (size(argument, value) / 2);
    }

    /** Returns a valid size that is not zero. */
    public static double positive(String argument, double value) {
        if (!(value > 0 && value <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be a number above 0 and at most 2^100 (got: " + value + ")");
        }
        return value;
    }

    /** Returns a valid share: from 0 to 1. */
    public static double share(String argument, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(argument + " must be a number from 0 to 1 (got: " + value + ")");
        }
        return value + 0.0;
    }

    /** Returns a valid angle in degrees: any finite number. */
    public static double angle(String argument, double degrees) {
        if (!Double.isFinite(degrees)) {
            throw new IllegalArgumentException(argument + " must be a finite angle in degrees (got: " + degrees + ")");
        }
        return degrees + 0.0;
    }

    public static String name(String value) {
        if (present("name", value).isBlank()) {
            throw new IllegalArgumentException("name must have a visible character (got: \"" + value + "\")");
        }
        return value;
    }

    /** An immutable copy of a set of names. */
    public static Set<String> names(String argument, Set<String> names) {
        for (String name : present(argument, names)) {
            name(name);
        }
        return Set.copyOf(names);
    }

    /**
     * An immutable copy of a list. Null, a null item, and an item of another type are refused; a deserialized list can
     * contain items of any type.
     */
    public static <T> List<T> copy(String argument, List<T> items, Class<T> type) {
        int k = 0;
        for (Object item : present(argument, items)) {
            if (!type.isInstance(item)) {
                throw new IllegalArgumentException(argument + "[" + k + "] must be "
                        + (item == null
                                ? "given (got: null)"
                                : "a " + type.getSimpleName() + " (got: "
                                        + item.getClass().getName() + ")"));
            }
            k++;
        }
        return List.copyOf(items);
    }

    public static double worldSize(String argument, double value) {
        if (!(value > 0 && value <= 2 * LIMIT)) {
            throw new IllegalArgumentException(argument + " must be above 0 and at most 2^101 (got: " + value + ")");
        }
        return value;
    }

    public static double clearance(double value) {
        if (!(value >= 0 && value <= LIMIT)) {
            throw new IllegalArgumentException("clearance must be from 0 to 2^100 (got: " + value + ")");
        }
        return value;
    }

    public static int count(int value) {
        if (value < 0) {
            throw new IllegalArgumentException("count must be at least 0 (got: " + value + ")");
        }
        return value;
    }

    /** Checks a blind range and a range; only the latter may be infinite. */
    public static void range(double min, double max) {
        if (!(min >= 0 && min <= LIMIT)) {
            throw new IllegalArgumentException("min must be from 0 to 2^100 (got: " + min + ")");
        }
        if (!(max >= min)) {
            throw new IllegalArgumentException("max must be at least min, " + min + " (got: " + max + ")");
        }
    }

    /** Returns a valid opening angle of a beam. */
    public static double width(double degrees) {
        if (!(degrees >= 0 && degrees < 180)) {
            throw new IllegalArgumentException(
                    "width must be from 0 up to, not including, 180 degrees (got: " + degrees + ")");
        }
        return degrees;
    }

    public static void radians(String argument, double value) {
        if (!(Math.abs(value) <= LIMIT)) {
            throw new IllegalArgumentException(
                    argument + " must be an angle in radians from -2^100 to 2^100 (got: " + value + ")");
        }
    }

    public static int port(int port, int least) {
        if (port < least || port > 65535) {
            throw new IllegalArgumentException("port must be " + least + " to 65535 (got: " + port + ")");
        }
        return port;
    }

    public static void time(String argument, Duration time, Duration longest) {
        present(argument, time);
        if (time.compareTo(Duration.ofMillis(1)) < 0 || time.compareTo(longest) > 0) {
            throw new IllegalArgumentException(argument + " must be from a millisecond to a day (got: " + time + ")");
        }
    }

    /** Returns a valid number of threads. */
    public static int threads(int count) {
        if (count < 1 || count > MOST_THREADS) {
            throw new IllegalArgumentException("threads must be from 1 to " + MOST_THREADS + " (got: " + count + ")");
        }
        return count;
    }

    public static void atLeastOne(String argument, int number) {
        if (number < 1) {
            throw new IllegalArgumentException(argument + " must be at least 1 (got: " + number + ")");
        }
    }
}

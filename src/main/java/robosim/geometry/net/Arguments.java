package robosim.geometry.net;

import java.time.Duration;

/** The rules for this package's own arguments. */
final class Arguments {
    private Arguments() {}

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }

    static int port(int port, int least) {
        if (port < least || port > 65535) {
            throw new IllegalArgumentException("port must be " + least + " to 65535 (got: " + port + ")");
        }
        return port;
    }

    static void time(String argument, Duration time, Duration longest) {
        present(argument, time);
        if (time.compareTo(Duration.ofMillis(1)) < 0 || time.compareTo(longest) > 0) {
            throw new IllegalArgumentException(argument + " must be from a millisecond to a day (got: " + time + ")");
        }
    }

    static void atLeastOne(String argument, int number) {
        if (number < 1) {
            throw new IllegalArgumentException(argument + " must be at least 1 (got: " + number + ")");
        }
    }
}

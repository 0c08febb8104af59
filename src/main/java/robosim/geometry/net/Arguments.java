package robosim.geometry.net;

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
}

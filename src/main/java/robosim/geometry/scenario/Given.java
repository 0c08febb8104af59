package robosim.geometry.scenario;

/** The rule for this package's arguments. */
final class Given {
    private Given() {}

    static <T> T present(String argument, T value) {
        if (value == null) {
            throw new IllegalArgumentException(argument + " must be given (got: null)");
        }
        return value;
    }
}

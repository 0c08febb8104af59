package robosim.geometry.reference;

/** A number that the oracle computes with: exactly, or coarsely with the right to have no opinion. */
public interface Quantity {
    Quantity plus(Quantity that);

    Quantity minus(Quantity that);

    Quantity times(Quantity that);

    Quantity negate();

    /**
     * -1, 0 or 1, and never wrong.
     *
     * @throws Doubt where the number is too coarse to tell
     */
    int signum();

    /** Whether it is seen not to be zero; false says nothing. */
    boolean isPlainlyNotZero();

    /** Which numbers to compute with. */
    interface Arithmetic {
        /** What a double stands for. */
        Quantity of(double value);
    }

    /** A coarse number did not tell its sign: ask again with exact ones. */
    final class Doubt extends RuntimeException {
        private static final long serialVersionUID = 1;

        static final Doubt INSTANCE = new Doubt();

        private Doubt() {
            super("too close for plain doubles", null, false, false);
        }
    }
}

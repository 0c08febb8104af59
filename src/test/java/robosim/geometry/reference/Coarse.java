package robosim.geometry.reference;

/**
 * A double and how far it may be off. Each operation is taken to round by 2^-40 of its result, eight thousand times what
 * it does; a sign is told only where the value is beyond all of that.
 */
final class Coarse implements Quantity {
    private static final double ROUNDING = 0x1p-40;

    /** A product below may be one that underflowed. */
    private static final double SMALL = 1e-280;

    private final double value;
    private final double error;

    private Coarse(double value, double error) {
        this.value = value;
        this.error = error;
    }

    static Coarse of(double value) {
        return new Coarse(value, 0);
    }

    @Override
    public Quantity plus(Quantity that) {
        Coarse other = (Coarse) that;
        double sum = value + other.value;
        return new Coarse(sum, error + other.error + ROUNDING * Math.abs(sum));
    }

    @Override
    public Quantity minus(Quantity that) {
        Coarse other = (Coarse) that;
        double difference = value - other.value;
        return new Coarse(difference, error + other.error + ROUNDING * Math.abs(difference));
    }

    @Override
    public Quantity times(Quantity that) {
        Coarse other = (Coarse) that;
        double product = value * other.value;
        double off = Math.abs(value) * other.error + Math.abs(other.value) * error + error * other.error;
        if (Math.abs(product) + off < SMALL && !isZero() && !other.isZero()) {
            return new Coarse(0, Double.POSITIVE_INFINITY);
        }
        return new Coarse(product, off * (1 + ROUNDING) + ROUNDING * Math.abs(product));
    }

    @Override
    public Quantity negate() {
        return new Coarse(-value, error);
    }

    private boolean isZero() {
        return value == 0 && error == 0;
    }

    @Override
    public int signum() {
        if (isPlainlyNotZero()) {
            return value > 0 ? 1 : -1;
        }
        if (isZero()) {
            return 0;
        }
        throw Doubt.INSTANCE;
    }

    @Override
    public boolean isPlainlyNotZero() {
        return Math.abs(value) > error; // false where either is no number
    }
}

package robosim.geometry.exact;

/** Quotients and square roots of exact numbers, rounded in a known direction. */
public final class ExactMath {
    private static final int BITS = 96;

    private ExactMath() {}

    /**
     * The largest double not above {@code p / q}; p must be at least 0, q above 0, and the quotient within the range of
     * doubles.
     */
    public static double floorQuotient(Dyadic p, Dyadic q) {
        if (p.signum() == 0) {
            return 0;
        }
        Dyadic over = inRange(p, q) ? p : unit(p, q);
        Dyadic under = inRange(p, q) ? q : unit(q, q);
        double quotient = over.doubleValue() / under.doubleValue();
        while (Dyadic.of(quotient).multiply(q).compareTo(p) > 0) {
            quotient = Math.nextDown(quotient);
        }
        while (Dyadic.of(Math.nextUp(quotient)).multiply(q).compareTo(p) <= 0) {
            quotient = Math.nextUp(quotient);
        }
        return quotient;
    }

    /** An upper bound of the square root of {@code square}, larger than it by at most 2^-90 of it. */
    public static Dyadic sqrtUp(Dyadic square) {
        if (square.signum() <= 0) {
            return Dyadic.ZERO;
        }
        Dyadic root = square.root(BITS); // rounded down
        return root.square().compareTo(square) == 0 ? root : root.add(Dyadic.ONE.scale(root.magnitude() - BITS + 1));
    }

    /** The sign of {@code p - q sqrt(square)}; {@code square} must be at least 0. */
    public static int compareToRoot(Dyadic p, Dyadic q, Dyadic square) {
        int right = q.signum() * square.signum();
        if (p.signum() != right) {
            return Integer.compare(p.signum(), right);
        }
        return right * p.square().compareTo(q.square().multiply(square));
    }

    private static boolean inRange(Dyadic p, Dyadic q) {
        return isOrdinary(p.abs().doubleValue()) && isOrdinary(q.abs().doubleValue());
    }

    private static boolean isOrdinary(double value) {
        return value > 0x1p-500 && value < 0x1p500;
    }

    // Scaled so that q becomes about 1.
    private static Dyadic unit(Dyadic value, Dyadic q) {
        return value.scale(-q.magnitude());
    }
}

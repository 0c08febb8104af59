package robosim.geometry.exact;

/** Quotients and square roots of exact numbers, rounded in a known direction. */
public final class ExactMath {
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
        int power = exponent(square) & ~1;
        Dyadic scaled = square.scale(-power); // from 1 up to, not including, 4
        double root = Math.sqrt(scaled.doubleValue());
        Dyadic missing = scaled.subtract(Dyadic.of(root).square());
        if (missing.signum() == 0) {
            return Dyadic.of(root).scale(power / 2);
        }
        double rest = missing.doubleValue() / (2 * root);
        return Dyadic.of(root).add(Dyadic.of(rest)).add(Dyadic.of(0x1p-95)).scale(power / 2);
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
        return value.scale(-exponent(q));
    }

    private static int exponent(Dyadic value) {
        Dyadic rest = value.abs();
        int power = 0;
        while (rest.doubleValue() >= 0x1p512) {
            rest = rest.scale(-512);
            power += 512;
        }
        while (rest.doubleValue() < 0x1p-512) {
            rest = rest.scale(512);
            power -= 512;
        }
        return power + Math.getExponent(rest.doubleValue());
    }
}

package robosim.geometry.exact;

import java.math.BigDecimal;
import java.util.SplittableRandom;

/** Doubles that are hard on arithmetic. */
final class Samples {
    private Samples() {}

    /** Any finite double: every exponent alike, zeros and subnormals among them. */
    static double any(SplittableRandom random) {
        while (true) {
            double value = switch (random.nextInt(12)) {
                case 0 -> random.nextBoolean() ? 0.0 : -0.0;
                case 1 -> random.nextInt(-50, 50) * Double.MIN_VALUE;
                case 2 -> random.nextInt(-50, 50);
                case 3 -> (random.nextBoolean() ? 1 : -1) * StrictMath.scalb(1.0, random.nextInt(-1074, 1023));
                default -> Double.longBitsToDouble(random.nextLong());
            };
            if (Double.isFinite(value)) {
                return value;
            }
        }
    }

    /** Of ordinary size, with all bits in use. */
    static double ordinary(SplittableRandom random) {
        return random.nextDouble(-1000, 1000);
    }

    /** A double up to three ulp away. */
    static double near(double value, SplittableRandom random) {
        double result = value;
        for (int steps = random.nextInt(-3, 4); steps != 0; steps -= Integer.signum(steps)) {
            result = steps > 0 ? Math.nextUp(result) : Math.nextDown(result);
        }
        return result;
    }

    static BigDecimal big(double value) {
        return new BigDecimal(value);
    }
}

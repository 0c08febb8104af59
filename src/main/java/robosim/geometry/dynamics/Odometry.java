package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Twist;

/**
 * What a robot measures of its own motion: the velocity it had, with an error that grows with what it moved, by the velocity
 * motion model (Thrun, Burgard and Fox 2005, 5.3). The errors of a step are drawn from the seed, the robot's name and the
 * number of the step alone, so a step gives the same on any machine and thread, asked once or again, in any order.
 *
 * <pre>{@code
 * Odometry odometry = new Odometry(0.02, 0.5, 3, 0.05, 42);
 * Twist first = odometry.measured(new Twist(1, 0, 0, 0), 0.1, "cart", 7);
 * first.equals(odometry.measured(new Twist(1, 0, 0, 0), 0.1, "cart", 7)); // true
 * first.equals(odometry.measured(new Twist(1, 0, 0, 0), 0.1, "cart", 8)); // false
 * }</pre>
 *
 * <p>The variances of the way and of the turn of a step are sums of what the way and the turn contribute, each in proportion
 * to its size, so they do not depend on how a motion is divided into steps. A robot that stands measures no motion.
 *
 * @param wayPerWay   standard deviation of the way after one metre, metres
 * @param wayPerTurn  standard deviation of the way after one full turn, metres
 * @param turnPerWay  standard deviation of the heading after one metre, degrees
 * @param turnPerTurn standard deviation of the heading after one degree of turning, degrees
 * @param seed        of the random draws
 */
public record Odometry(double wayPerWay, double wayPerTurn, double turnPerWay, double turnPerTurn, long seed) {
    /** Refuses values that are out of range or not a number. */
    public Odometry {
        wayPerWay = QuantityChecks.atLeastZero("wayPerWay", wayPerWay);
        wayPerTurn = QuantityChecks.atLeastZero("wayPerTurn", wayPerTurn);
        turnPerWay = QuantityChecks.atLeastZero("turnPerWay", turnPerWay);
        turnPerTurn = QuantityChecks.atLeastZero("turnPerTurn", turnPerTurn);
    }

    /**
     * What a robot measures of a velocity that it had during a step. The errors forward and to the right are independent;
     * heights are measured without error.
     *
     * @param had     along the own axes
     * @param seconds length of the step; above 0
     * @param robot   its name
     * @param step    number of the step
     */
    public Twist measured(Twist had, double seconds, String robot, long step) {
        Checks.present("had", had);
        QuantityChecks.positive("seconds", seconds);
        long state = OdometryNoise.start(seed, Checks.present("robot", robot), step);
        double way = Math.sqrt(had.x() * had.x() + had.z() * had.z()) * seconds;
        double turn = Math.abs(had.ry()) * seconds;
        double ofWay = Math.sqrt(wayPerWay * wayPerWay * way + wayPerTurn * wayPerTurn * (turn / 360)) / seconds;
        double ofTurn = Math.sqrt(turnPerWay * turnPerWay * way + turnPerTurn * turnPerTurn * turn) / seconds;
        double sideways = had.z() == 0 ? 0 : ofWay * OdometryNoise.normal(state, 1);
        return new Twist(
                had.x() + ofWay * OdometryNoise.normal(state, 0),
                had.y(),
                had.z() + sideways,
                had.ry() + ofTurn * OdometryNoise.normal(state, 2));
    }

    /** Random numbers that depend on their key alone: SplitMix64 (Steele, Lea and Flood 2014) over what is mixed in. */
    private static final class OdometryNoise {
        private static final long GOLDEN = 0x9E3779B97F4A7C15L;

        /** Ends a name; not a UTF-16 code unit. */
        private static final long END = 0x10000;

        private OdometryNoise() {}

        /** The state from which the draws of a step are made. */
        static long start(long seed, String robot, long step) {
            long state = mix(seed);
            for (int k = 0; k < robot.length(); k++) {
                state = mix(state ^ robot.charAt(k));
            }
            return mix(mix(state ^ END) ^ step);
        }

        /** One of the independent normal deviates of a state, by the method of Box and Muller 1958. */
        static double normal(long state, int draw) {
            // Above 0, so that it has a logarithm, and at most 1.
            double u = ((mix(state + 2L * draw) >>> 11) + 1) * 0x1p-53;
            double v = (mix(state + 2L * draw + 1) >>> 11) * 0x1p-53;
            return Math.sqrt(-2 * StrictMath.log(u)) * Degrees.cos(360 * v);
        }

        private static long mix(long word) {
            long z = word + GOLDEN;
            z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
            z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
            return z ^ (z >>> 31);
        }
    }
}

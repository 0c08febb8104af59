package robosim.geometry.dynamics;

import robosim.geometry.check.Checks;

/**
 * How a surface bounces and rubs, by Newton's law of restitution and Coulomb's law of friction (Mirtich 1996).
 *
 * <pre>{@code
 * Surface rubber = new Surface(0.8, 0.9, 0.7);
 * Surface ice = new Surface(0.2, 0.1, 0.028);
 * rubber.against(ice).slidingFriction(); // 0.14
 * }</pre>
 *
 * @param restitution     the share of the speed of approach at which two such surfaces part, from 0 to 1
 * @param staticFriction  the most that friction is, as a share of the force across the contact, while nothing slides
 * @param slidingFriction the same while it slides; at most {@code staticFriction}
 */
public record Surface(double restitution, double staticFriction, double slidingFriction) {
    /** How the numbers of two surfaces, restitution or friction, make that of their contact. */
    public enum Mixing {
        /** The square root of the product, the default for both: one smooth surface makes the contact smooth. */
        GEOMETRIC_MEAN,
        /** The arithmetic mean. */
        MEAN,
        /** The larger one, as dyn4j and Box2D have it for restitution. */
        LARGER,
        /** The smaller one, as ODE, and so Gazebo, have it for friction. */
        SMALLER,
        /** The product, as Bullet has it for both. */
        PRODUCT;

        /** The number of a contact. */
        public double of(double a, double b) {
            return switch (this) {
                case GEOMETRIC_MEAN -> a == b ? a : Math.sqrt(a * b);
                case MEAN -> a == b ? a : a / 2 + b / 2;
                case LARGER -> Math.max(a, b);
                case SMALLER -> Math.min(a, b);
                case PRODUCT -> a * b;
            };
        }
    }

    /** Neither bounces nor rubs. */
    public static final Surface SMOOTH = new Surface(0, 0, 0);

    /** Refuses values that are out of range or not a number. */
    public Surface {
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("restitution must be from 0 to 1 (got: " + restitution + ")");
        }
        restitution += 0.0;
        staticFriction = QuantityChecks.atLeastZero("staticFriction", staticFriction);
        slidingFriction = QuantityChecks.atLeastZero("slidingFriction", slidingFriction);
        if (slidingFriction > staticFriction) {
            throw new IllegalArgumentException("slidingFriction must be at most staticFriction (got: " + slidingFriction
                    + " above " + staticFriction + ")");
        }
    }

    /**
     * The surface that stands for the contact of two: of each number the geometric mean, a convention of physics engines
     * by which equal surfaces give themselves and a smooth one makes the contact smooth.
     */
    public Surface against(Surface other) {
        return against(other, Mixing.GEOMETRIC_MEAN, Mixing.GEOMETRIC_MEAN);
    }

    /** The surface that stands for the contact of two by other rules, as {@link Dynamics#mix} sets them. */
    public Surface against(Surface other, Mixing ofRestitution, Mixing ofFriction) {
        Checks.present("other", other);
        double still = Checks.present("ofFriction", ofFriction).of(staticFriction, other.staticFriction);
        return new Surface(
                Math.min(1, Checks.present("ofRestitution", ofRestitution).of(restitution, other.restitution)),
                still,
                Math.min(still, ofFriction.of(slidingFriction, other.slidingFriction)));
    }
}

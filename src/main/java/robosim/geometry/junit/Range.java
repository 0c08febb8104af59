package robosim.geometry.junit;

import robosim.geometry.check.Text;
import robosim.geometry.collision.Verdict;

/**
 * A robot with the distance between its surface and another object's, to within the last bits. It is measured once. An
 * assertion about it fails only if it is certainly false.
 */
public final class Range extends Robot {
    private final String other;
    private final Verdict verdict;

    Range(RobotWorld world, String robot, String other) {
        super(world, robot);
        this.other = other;
        this.verdict = world.distance(robot, other);
    }

    /** The distance in world units, rounded down; 0 in contact. */
    public double value() {
        return verdict.low();
    }

    /** Fails if they are nearer. */
    public Range isAtLeast(double distance) {
        check("distance", distance);
        if (verdict.high() < distance) {
            throw apart("at least", distance, verdict.high());
        }
        return this;
    }

    /** Fails if they are farther apart. */
    public Range isAtMost(double distance) {
        check("distance", distance);
        if (verdict.low() > distance) {
            throw apart("at most", distance, verdict.low());
        }
        return this;
    }

    private AssertionError apart(String relation, double distance, double found) {
        return failure(" was to be " + relation + " " + FailureFormat.number(distance) + " from " + Text.quoted(other)
                + ", but is " + FailureFormat.apart(found, distance) + " from it; it stands "
                + FailureFormat.place(object()));
    }
}

package robosim.geometry.junit;

import robosim.geometry.collision.Verdict;
import robosim.geometry.protocol.Text;

/**
 * The distance between the surfaces of a robot and another object, to within the last bits. An assertion about it fails
 * only if it is certainly false.
 */
public final class Range {
    private final Robot robot;
    private final String other;
    private final Verdict verdict;

    Range(Robot robot, String other, Verdict verdict) {
        this.robot = robot;
        this.other = other;
        this.verdict = verdict;
    }

    /** The distance in world units, rounded down; 0 in contact. */
    public double value() {
        return verdict.low();
    }

    /** Fails if they are nearer. */
    public Robot isAtLeast(double distance) {
        Robot.check("distance", distance);
        if (verdict.high() < distance) {
            throw failure("at least", distance, verdict.high());
        }
        return robot;
    }

    /** Fails if they are farther apart. */
    public Robot isAtMost(double distance) {
        Robot.check("distance", distance);
        if (verdict.low() > distance) {
            throw failure("at most", distance, verdict.low());
        }
        return robot;
    }

    private AssertionError failure(String relation, double distance, double found) {
        return robot.failure(" was to be " + relation + " " + Words.number(distance) + " from " + Text.quoted(other)
                + ", but is " + Words.apart(found, distance) + " from it; it stands " + Words.place(robot.object()));
    }
}

package robosim.geometry.junit;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Beam;
import robosim.geometry.world.SonarRing;

/**
 * A sonar that the world's file gives a robot, with its range and its cone, for an assertion. It measures once, when it is
 * asked for, from the robot's centre.
 */
public final class Sonar {
    private final Robot robot;
    private final int number;
    private final SonarRing ring;
    private final double direction;
    private final double reading;

    /**
     * Measures.
     *
     * @param number of the sonar among all of the robot, from 0
     * @param index  of the sonar in its ring
     */
    Sonar(RobotWorld world, Robot robot, int number, SonarRing ring, int index) {
        this.robot = robot;
        this.number = number;
        this.ring = ring;
        direction = ring.first() + index * ring.step();
        Point towards = ring.direction(index);
        Beam beam = new Beam(ring.min(), ring.max(), Degrees.toRadians(ring.width()));
        reading = world.measure(robot.name(), towards.x(), towards.z(), beam);
    }

    /** Its direction, degrees counter-clockwise from the robot's forward direction. */
    public double direction() {
        return direction;
    }

    /**
     * What it reads: the distance of the first echo in its cone, its blind range if that is nearer, or {@code +Infinity}
     * where nothing echoes within its range.
     */
    public double reads() {
        return reading;
    }

    /** Fails if it reads less. */
    public Robot isAtLeast(double distance) {
        Robot.check("distance", distance);
        if (reading < distance) {
            throw failure("at least " + Words.number(distance), Words.apart(reading, distance));
        }
        return robot;
    }

    /** Fails if it reads more, or nothing. */
    public Robot isAtMost(double distance) {
        Robot.check("distance", distance);
        if (reading > distance) {
            throw failure("at most " + Words.number(distance), echo(distance));
        }
        return robot;
    }

    /** Fails if anything echoes within its range. */
    public Robot readsNothing() {
        if (!Double.isInfinite(reading)) {
            throw failure("nothing", Words.found(reading));
        }
        return robot;
    }

    private String echo(double asked) {
        return Double.isInfinite(reading)
                ? "nothing within its range of " + Words.number(ring.max())
                : Words.apart(reading, asked);
    }

    private AssertionError failure(String expected, String found) {
        return robot.failure(" was to read " + expected + " by its sonar " + number + ", at " + Words.number(direction)
                + " degrees, but it reads " + found + "; it stands " + Words.place(robot.object()));
    }
}

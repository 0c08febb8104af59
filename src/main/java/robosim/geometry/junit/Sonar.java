package robosim.geometry.junit;

import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Beam;
import robosim.geometry.world.SonarRing;

/**
 * A robot with one of the sonars that the world's file gives it, with its range and its cone, for an assertion. It measures
 * once, when it is asked for, from the robot's centre.
 */
public final class Sonar extends Robot {
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
    Sonar(RobotWorld world, String robot, int number, SonarRing ring, int index) {
        super(world, robot);
        this.number = number;
        this.ring = ring;
        direction = ring.first() + index * ring.step();
        Point towards = ring.direction(index);
        Beam beam = new Beam(ring.min(), ring.max(), Degrees.toRadians(ring.width()));
        reading = world.measure(robot, towards.x(), towards.z(), beam);
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
    public Sonar isAtLeast(double distance) {
        check("distance", distance);
        if (reading < distance) {
            throw misread("at least " + FailureFormat.number(distance), FailureFormat.apart(reading, distance));
        }
        return this;
    }

    /** Fails if it reads more, or nothing. */
    public Sonar isAtMost(double distance) {
        check("distance", distance);
        if (reading > distance) {
            throw misread("at most " + FailureFormat.number(distance), echo(distance));
        }
        return this;
    }

    /** Fails if anything echoes within its range. */
    public Sonar readsNothing() {
        if (!Double.isInfinite(reading)) {
            throw misread("nothing", FailureFormat.found(reading));
        }
        return this;
    }

    private String echo(double asked) {
        return Double.isInfinite(reading)
                ? "nothing within its range of " + FailureFormat.number(ring.max())
                : FailureFormat.apart(reading, asked);
    }

    private AssertionError misread(String expected, String found) {
        return failure(
                " was to read " + expected + " by its sonar " + number + ", at " + FailureFormat.number(direction)
                        + " degrees, but it reads " + found + "; it stands " + FailureFormat.place(object()));
    }
}

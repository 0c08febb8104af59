package robosim.geometry.junit;

import java.util.function.Consumer;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.MoveResult;
import robosim.geometry.exact.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.protocol.Text;

/**
 * A robot of a {@link RobotWorld}, for sentences about what it does: each either holds or fails the test with what is in
 * its way, and where. Distances are world units; directions are degrees, counter-clockwise from its forward.
 */
public final class Robot {
    private final RobotWorld world;
    private final String name;

    Robot(RobotWorld world, String name) {
        this.world = world;
        this.name = name;
    }

    /** Its name in the world. */
    public String name() {
        return name;
    }

    /** As it is now. */
    public GeometryObject object() {
        return world.known(name);
    }

    /** Where it is. */
    public Point center() {
        return object().center();
    }

    /** Where it looks, degrees from the world's X. */
    public double heading() {
        return object().heading();
    }

    /** Goes straight ahead, or back; fails where anything blocks the way. */
    public Robot drives(double distance) {
        return moves(new Move(distance, 0, 0, 0, 0));
    }

    /** Turns in place about the vertical; fails where anything blocks it. */
    public Robot turns(double degrees) {
        return moves(new Move(0, 0, 0, 0, degrees));
    }

    /** Moves along its own axes; fails where anything blocks it. */
    public Robot moves(Move move) {
        Checks.present("move", move);
        MoveResult result = world.move(name, move);
        if (!result.allowed()) {
            throw failure(" was to " + Words.move(move) + world.moment() + ", but is " + Words.blocked(move, result)
                    + "; it stands " + Words.place(object()));
        }
        return this;
    }

    /** Goes ahead if nothing blocks the way, as a robot does that explores; to be refused is no failure. */
    public boolean triesToDrive(double distance) {
        return tries(new Move(distance, 0, 0, 0, 0));
    }

    /** Turns if nothing blocks it; to be refused is no failure. */
    public boolean triesToTurn(double degrees) {
        return tries(new Move(0, 0, 0, 0, degrees));
    }

    /** Makes a move if nothing blocks it; to be refused is no failure. */
    public boolean tries(Move move) {
        Checks.present("move", move);
        return world.move(name, move).allowed();
    }

    /** Fails where it can go so far; the way must be blocked by that object. It stays where it is. */
    public Robot isBlockedBy(String obstacle, double distance) {
        Checks.present("obstacle", obstacle);
        world.known(obstacle);
        Move move = new Move(distance, 0, 0, 0, 0);
        MoveResult result = world.move(name, move);
        GeometryObject met = result.obstacle();
        if (result.allowed()) {
            throw failure(" was to be blocked by " + Text.quoted(obstacle) + " when it drives " + Words.number(distance)
                    + world.moment() + ", but nothing is in its way; it stands " + Words.place(object()));
        }
        if (met == null || !obstacle.equals(met.name())) {
            throw failure(" was to be blocked by " + Text.quoted(obstacle) + world.moment() + ", but is "
                    + Words.blocked(move, result) + "; it stands " + Words.place(object()));
        }
        return this;
    }

    /** How far it is from its centre to the next surface in a direction; {@code +Infinity} where there is none. */
    public double range(double direction) {
        return world.measure(name, direction);
    }

    /** Fails where nothing echoes in a direction within a range. */
    public Robot senses(double direction, double range) {
        check("range", range);
        double distance = range(direction);
        if (distance > range) {
            throw failure(" was to sense something within " + Words.number(range) + sight(direction) + ", but "
                    + echo(direction, distance, range) + "; it stands " + Words.place(object()));
        }
        return this;
    }

    /** Fails where something echoes in a direction within a range. */
    public Robot sensesNothing(double direction, double range) {
        check("range", range);
        double distance = range(direction);
        if (distance <= range) {
            throw failure(" was to sense nothing within " + Words.number(range) + sight(direction) + ", but "
                    + echo(direction, distance, range) + "; it stands " + Words.place(object()));
        }
        return this;
    }

    static void check(String argument, double distance) {
        if (!(distance >= 0)) {
            throw new IllegalArgumentException(argument + " must be at least 0 (got: " + distance + ")");
        }
    }

    private String sight(double direction) {
        return " at " + Words.number(direction) + " degrees" + world.moment();
    }

    private String echo(double direction, double distance, double range) {
        if (Double.isInfinite(distance)) {
            return "nothing echoes there at any distance";
        }
        Point from = center();
        double heading = heading() + direction;
        Point at = new Point(
                from.x() + distance * Degrees.cos(heading), from.y(), from.z() - distance * Degrees.sin(heading));
        return "the first echo is " + Words.apart(distance, range) + " away, at about " + Words.point(at, distance);
    }

    /**
     * Fails where it touches an object now, has run into it, or it into the robot, and from now on when that happens in this
     * test. As nothing moves into anything, to run into it is to be stopped by it.
     */
    public Robot neverTouches(String other) {
        Checks.present("other", other);
        world.watch(name, other);
        return this;
    }

    /** The distance between its surface and another object's, for a sentence about it. */
    public Range rangeTo(String other) {
        Checks.present("other", other);
        return new Range(this, other, world.distance(name, other));
    }

    /** What it does in each step of the clock. */
    public Robot follows(Consumer<Robot> behaviour) {
        Checks.present("behaviour", behaviour);
        world.clock().each(() -> behaviour.accept(this));
        return this;
    }

    /** A sentence about where it comes to, which the steps end that are granted. */
    public Arrival reaches(Goal goal) {
        Checks.present("goal", goal);
        return new Arrival(world, this, goal);
    }

    AssertionFailedError failure(String words) {
        return new AssertionFailedError(this + words);
    }

    @Override
    public String toString() {
        return "robot " + Text.quoted(name);
    }
}

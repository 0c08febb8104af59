package robosim.geometry.junit;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.world.SonarRing;

/**
 * A robot of a {@link RobotWorld}, with commands and assertions that read like sentences. Each either succeeds or fails
 * the test with a message that names what is in the way, and where. An object that robots push is described in the same words.
 * Distances are in world units; directions in degrees,
 * counter-clockwise from its forward direction.
 *
 * <p>A sentence that measures, such as {@link #rangeTo}, goes on with more about what was measured, or with anything else
 * about the robot: {@code robot.rangeTo("wall").isAtLeast(1).isAtMost(2).drives(0.5)}.
 */
public sealed class Robot permits Range, Sonar {
    private final RobotWorld world;
    private final String kind;
    private final String name;

    Robot(RobotWorld world, String name) {
        this(world, "robot", name);
    }

    /**
     * Something in a world.
     *
     * @param kind the word for it in messages
     */
    Robot(RobotWorld world, String kind, String name) {
        this.world = world;
        this.kind = kind;
        this.name = name;
    }

    /** Its name in the world. */
    public String name() {
        return name;
    }

    /** The robot's object at its present place. */
    public GeometryObject object() {
        return world.known(name);
    }

    /** The centre. */
    public Point center() {
        return object().center();
    }

    /** The heading, degrees from the world's X. */
    public double heading() {
        return object().heading();
    }

    /** Moves straight ahead, or back if negative; fails if anything blocks the way. */
    public Robot drives(double distance) {
        return moves(new Move(distance, 0, 0, 0, 0));
    }

    /**
     * Tells it to drive from now on: it has a body, is driven within its limits, slides, pushes and is pushed, and never
     * overlaps anything. Without a {@linkplain #hasBody body} or a {@linkplain #hasDrive drive} it gets that of a solid of
     * its shape, 200 kg/m<sup>3</sup>, and two wheels as far apart as it is wide.
     *
     * @param speed m/s forward; a world unit is a metre
     * @param turn  degrees a second, counter-clockwise; of a car the angle of its front wheels, which turns it about its rear
     *              axle; of a {@code ForceDrive} newton metres
     */
    public Robot drives(double speed, double turn) {
        world.tell(name, speed, 0, turn);
        return this;
    }

    /**
     * Tells it to drive in any direction from now on, as {@link #drives(double, double)}; an error for drives that cannot.
     *
     * @param forward m/s forward; of a {@code ForceDrive} newtons
     * @param right   m/s to the right; of a {@code ForceDrive} newtons
     * @param turn    degrees a second, counter-clockwise; of a {@code ForceDrive} newton metres
     */
    public Robot drives(double forward, double right, double turn) {
        world.tell(name, forward, right, turn);
        return this;
    }

    /**
     * Lets time pass for the whole world, in steps of its clock: every body moves as it is driven and pushed. Then lets the
     * robot stand, which it does as soon as its drive can.
     *
     * @param seconds a multiple of the clock's step
     */
    public Robot forSeconds(double seconds) {
        world.elapse(seconds);
        world.tell(name, 0, 0, 0);
        return this;
    }

    /** Gives it a body of so many kilograms, in the shape of a solid. */
    public Robot hasMass(double kilograms) {
        world.give(world.body(name).withMass(kilograms));
        return this;
    }

    /** Lets it bounce and rub; see {@link Surface}. */
    public Robot hasSurface(Surface surface) {
        world.give(world.body(name).withSurface(SurfaceSettings.of(surface)));
        return this;
    }

    /** Gives it sliding friction on the floor, 0 for what rolls; 0.5 otherwise. */
    public Robot hasFloorFriction(double friction) {
        world.give(world.body(name).withFloorFriction(friction));
        return this;
    }

    /** Lets its speed, and its speed of turning, fall by shares each second, as on a floor that resists. */
    public Robot hasDamping(double ofSpeed, double ofTurn) {
        world.give(world.body(name).withDamping(ofSpeed, ofTurn));
        return this;
    }

    /** Gives it a body. */
    public Robot hasBody(Body body) {
        BodyRequest asked = BodyRequest.of(name, Checks.present("body", body), null);
        DriveSettings drive = world.body(name).drive();
        world.give(drive == null ? asked : asked.withDrive(drive));
        return this;
    }

    /** Gives it a drive; its command does not count. */
    public Robot hasDrive(Drive drive) {
        world.give(world.body(name).withDrive(DriveSettings.of(Checks.present("drive", drive))));
        return this;
    }

    /**
     * Attaches an object to it where it is now, as {@link robosim.geometry.Geometry#attach(String, String)} does: a gripper that
     * closes, a hook that catches. While robots drive, mass and momentum of both are put together.
     */
    public Robot attach(String load) {
        world.geometry().attach(name, load);
        return this;
    }

    /** Detaches an object from what carries it; it goes on as fast as its place went. */
    public Robot detach(String load) {
        world.geometry().detach(load);
        return this;
    }

    /** Takes its drive from it: it goes on by itself, and is pushed. */
    public Robot losesDrive() {
        world.give(world.body(name).withDrive(DriveSettings.of(DriveSettings.Kind.NONE)));
        return this;
    }

    /** Kicks it in the next step: an impulse through its centre, newton seconds along the world's axes. */
    public Robot getsImpulse(Point impulse) {
        world.push(PushRequest.impulse(name, Checks.present("impulse", impulse)));
        return this;
    }

    /** Pushes it all through the next step, and no longer: a force through its centre, newtons along the world's axes. */
    public Robot getsForce(Point force) {
        world.push(PushRequest.force(name, Checks.present("force", force)));
        return this;
    }

    /**
     * Its velocity after the last step of the clock, along its own axes: m/s, and degrees a second about its own Y, which is how
     * fast its heading changes while it stands upright. Zero for what has no body.
     */
    public Twist velocity() {
        BodyAnswer body = world.answer(name);
        return body == null ? new Twist(0, 0, 0, 0) : body.velocity().twist();
    }

    /**
     * What it touched or collided with in the last step of the clock, the ground too, and what it parted from. The normal of
     * each points towards the {@code body} of the contact, which may be the other one.
     */
    public List<BodyContact> contacts() {
        return world.contacts(name).stream().map(ContactAnswer::contact).toList();
    }

    /** Fails unless it and an object have met so far while bodies moved: one ran into the other. */
    public Robot hits(String other) {
        Checks.present("other", other);
        world.known(other);
        if (world.meetings().stream().noneMatch(meeting -> meeting.isBetween(name, other))) {
            throw failure(" was to hit " + Text.quoted(other) + world.moment() + ", but " + met() + "; it stands "
                    + FailureFormat.place(object()));
        }
        return this;
    }

    /** Fails unless it and another body have met so far. */
    public Robot isBumpedBy(String other) {
        hits(other);
        if (!world.isBody(other)) {
            throw failure(" was to be bumped by " + Text.quoted(other) + ", but that is no body, which stood still");
        }
        return this;
    }

    /**
     * Fails if it has met anything so far while bodies moved. What carries it does not count: the ground, which is the lower
     * border of the world, a floor or anything static on which it stands. But where it falls by more than its own height, it
     * hits what it falls on.
     */
    public Robot hitsNothing() {
        if (!world.met(name).isEmpty()) {
            throw failure(" was to hit nothing, but " + met() + "; it stands " + FailureFormat.place(object()));
        }
        return this;
    }

    private String met() {
        List<Bodies.Meeting> met = world.met(name);
        if (met.isEmpty()) {
            return "has met nothing";
        }
        Bodies.Meeting first = met.get(0);
        String other = world.words(first, name);
        long others = met.stream()
                .map(each -> world.words(each, name))
                .filter(each -> !each.equals(other))
                .distinct()
                .count();
        return "has met " + other + " in step " + first.step() + " at "
                + FailureFormat.point(first.contact().point(), 0)
                + (others == 0 ? "" : " and " + others + " more");
    }

    /** Fails if it is not within a distance of a place on the ground. */
    public Robot endsNear(double x, double z, double within) {
        world.checkNear(kind, name, x, z, within);
        return this;
    }

    /** Turns in place about the vertical; fails if anything blocks it. */
    public Robot turns(double degrees) {
        return moves(new Move(0, 0, 0, 0, degrees));
    }

    /** Moves along its own axes; fails if anything blocks it. */
    public Robot moves(Move move) {
        Checks.present("move", move);
        MoveResult result = world.move(name, move);
        if (!result.allowed()) {
            throw failure(" was to " + FailureFormat.move(move) + world.moment() + ", but is "
                    + FailureFormat.blocked(move, result) + "; it stands " + FailureFormat.place(object()));
        }
        return this;
    }

    /**
     * Moves straight ahead unless something blocks the way, as an exploring robot does; a refused move is not a
     * failure.
     */
    public boolean triesToDrive(double distance) {
        return tries(new Move(distance, 0, 0, 0, 0));
    }

    /** Turns unless something blocks it; a refused turn is not a failure. */
    public boolean triesToTurn(double degrees) {
        return tries(new Move(0, 0, 0, 0, degrees));
    }

    /** Makes a move unless something blocks it; a refused move is not a failure. */
    public boolean tries(Move move) {
        Checks.present("move", move);
        return world.move(name, move).allowed();
    }

    /** Asserts that driving the given distance is blocked by the given object. The robot stays where it is. */
    public Robot isBlockedBy(String obstacle, double distance) {
        Checks.present("obstacle", obstacle);
        world.known(obstacle);
        Move move = new Move(distance, 0, 0, 0, 0);
        MoveResult result = world.move(name, move);
        GeometryObject met = result.obstacle();
        if (result.allowed()) {
            throw failure(" was to be blocked by " + Text.quoted(obstacle) + " when it drives "
                    + FailureFormat.number(distance) + world.moment() + ", but nothing is in its way; it stands "
                    + FailureFormat.place(object()));
        }
        if (met == null || !obstacle.equals(met.name())) {
            throw failure(" was to be blocked by " + Text.quoted(obstacle) + world.moment() + ", but is "
                    + FailureFormat.blocked(move, result) + "; it stands " + FailureFormat.place(object()));
        }
        return this;
    }

    /** The distance from its centre to the nearest surface in a direction; {@code +Infinity} if there is none. */
    public double range(double direction) {
        return world.measure(name, direction);
    }

    /**
     * The distance from its centre, not from its rim, to the nearest surface of another object in a cone; {@code
     * +Infinity} if there is none.
     *
     * @param width full opening angle in degrees, from 0 (a line) up to, not including, 180
     */
    public double range(double direction, double width) {
        Checks.refuse(
                !(width >= 0 && width < 180),
                "width must be 0 to below 180 degrees",
                width); // written so that NaN fails it
        return world.measure(
                name,
                Degrees.cos(direction),
                -Degrees.sin(direction),
                new Beam(0, Double.POSITIVE_INFINITY, Degrees.toRadians(width)));
    }

    /**
     * One of the sonars that the world's file gives it.
     *
     * @param number from 0, in the order of the file
     * @throws IllegalArgumentException if it has no such sonar
     */
    public Sonar sonar(int number) {
        int from = 0;
        for (SonarRing ring : world.sonars(name)) {
            if (number >= from && number - from < ring.count()) {
                return new Sonar(world, name, number, ring, number - from);
            }
            from += ring.count();
        }
        throw new IllegalArgumentException(
                from == 0
                        ? "a robot with sonars must have a <sonar> in its world's file (got: " + this + ", without any)"
                        : "number must be 0 to " + (from - 1) + ", of the sonars of " + this + " (got: " + number
                                + ")");
    }

    /** What all the sonars that the world's file gives it read, in the order of the file. */
    public double[] sonars() {
        List<SonarRing> rings = world.sonars(name);
        double[] readings = new double[rings.stream().mapToInt(SonarRing::count).sum()];
        for (int k = 0; k < readings.length; k++) {
            readings[k] = sonar(k).reads();
        }
        return readings;
    }

    /** Fails if nothing echoes in a cone within a range; {@code width} is its full opening angle in degrees. */
    public Robot senses(double direction, double range, double width) {
        check("range", range);
        return senses(true, range, range(direction, width), sight(direction, width), "");
    }

    /** Fails if something echoes in a cone within a range; {@code width} is its full opening angle in degrees. */
    public Robot sensesNothing(double direction, double range, double width) {
        check("range", range);
        return senses(false, range, range(direction, width), sight(direction, width), "");
    }

    private String sight(double direction, double width) {
        return " in a cone of " + FailureFormat.number(width) + " degrees" + sight(direction);
    }

    private Robot senses(boolean something, double range, double distance, String sight, String place) {
        if (distance > range == something) {
            throw failure(
                    " was to sense " + (something ? "something" : "nothing") + " within " + FailureFormat.number(range)
                            + sight + ", but "
                            + (Double.isInfinite(distance)
                                    ? "nothing echoes there at any distance"
                                    : "the first echo is " + FailureFormat.apart(distance, range) + " away" + place)
                            + "; it stands " + FailureFormat.place(object()));
        }
        return this;
    }

    /** Fails if nothing echoes in a direction within a range. */
    public Robot senses(double direction, double range) {
        check("range", range);
        double distance = range(direction);
        return senses(true, range, distance, sight(direction), echo(direction, distance));
    }

    /** Fails if something echoes in a direction within a range. */
    public Robot sensesNothing(double direction, double range) {
        check("range", range);
        double distance = range(direction);
        return senses(false, range, distance, sight(direction), echo(direction, distance));
    }

    static void check(String argument, double distance) {
        Checks.refuse(!(distance >= 0), argument + " must be at least 0", distance);
    }

    private String sight(double direction) {
        return " at " + FailureFormat.number(direction) + " degrees" + world.moment();
    }

    /** Where an echo comes from, for a message; empty if there is none. */
    private String echo(double direction, double distance) {
        if (Double.isInfinite(distance)) {
            return "";
        }
        Point from = center();
        double heading = heading() + direction;
        Point at = new Point(
                from.x() + distance * Degrees.cos(heading), from.y(), from.z() - distance * Degrees.sin(heading));
        return ", at about " + FailureFormat.point(at, distance);
    }

    /**
     * Fails if the robot touches an object now, or if either has run into the other so far, and from now on whenever
     * that happens in this test. Since no move goes into another object, running into it means being stopped by it: also
     * by a refused {@link #triesToDrive}.
     */
    public Robot neverTouches(String other) {
        Checks.present("other", other);
        world.watch(name, other);
        return this;
    }

    /**
     * Fails if the robot touches any object now, or if it and an object or the world's border have run into each other so
     * far, and from now on whenever that happens in this test: {@link #neverTouches} of everything, whether it has a name
     * or not. What carries the robot does not count, as in {@link #hitsNothing}: the ground, which is the lower border of the
     * world, or a floor.
     */
    public Robot neverTouchesAnything() {
        return neverTouchesAnythingBut();
    }

    /**
     * As {@link #neverTouchesAnything}, but for some objects, such as what it is to push.
     *
     * @param others names
     */
    public Robot neverTouchesAnythingBut(String... others) {
        Set<String> names = new LinkedHashSet<>();
        for (String other : Checks.present("others", others)) {
            names.add(Checks.present("other", other));
        }
        world.watch(name, names);
        return this;
    }

    /** The distance between its surface and another object's, for an assertion. */
    public Range rangeTo(String other) {
        Checks.present("other", other);
        return new Range(world, name, other);
    }

    /** Sets what it does in each step of the clock. */
    public Robot follows(Consumer<Robot> behaviour) {
        Checks.present("behaviour", behaviour);
        world.clock().each(() -> behaviour.accept(this));
        return this;
    }

    /** Begins an assertion that it reaches a goal; completed by {@link Arrival#within}. */
    public Arrival reaches(Goal goal) {
        Checks.present("goal", goal);
        return new Arrival(world, this, goal);
    }

    AssertionFailedError failure(String words) {
        return new AssertionFailedError(this + words);
    }

    @Override
    public String toString() {
        return kind + " " + Text.quoted(name);
    }
}

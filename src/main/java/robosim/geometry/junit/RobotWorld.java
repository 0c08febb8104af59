package robosim.geometry.junit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.opentest4j.AssertionFailedError;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.check.Checks;
import robosim.geometry.check.Text;
import robosim.geometry.collision.Budget;
import robosim.geometry.collision.ContactQuery;
import robosim.geometry.collision.Verdict;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.net.session.BodyStepper;
import robosim.geometry.protocol.Beam;
import robosim.geometry.protocol.MoveRequest;
import robosim.geometry.protocol.Reply;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.DriveSettings.Kind;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.scenario.Scenario;
import robosim.geometry.scenario.drive.WorldBodies;
import robosim.geometry.world.SonarRing;

/**
 * A world with robots that are addressed by name, and a clock. What the robots do is recorded, so that a failed test
 * can leave a scenario that replays it. May be used by one thread at a time.
 *
 * <pre>{@code
 * RobotWorld world = RobotWorld.from(WorldReader.read(Path.of("worlds/rooms.xml")));
 * world.robot("drum 1").drives(2.0).turns(90).senses(0, 3.0).rangeTo("bench 1").isAtLeast(0.5);
 * world.robots().size(); // 8
 * }</pre>
 *
 * <p>Angles are degrees, counter-clockwise seen from above. A turn is carried out like a peer's request, which is in
 * radians: quarter turns are exact, other angles are accurate to the last bits.
 */
public final class RobotWorld {
    private static final int MOST_STEPS = 10_000_000;

    private final Geometry geometry;
    private final VirtualClock clock;
    private final Transcript transcript;
    private final Map<String, Robot> robots = new LinkedHashMap<>();
    private final Watches watches;

    private @Nullable Goal sought;

    /** The file that it came from, for colours, the unit and sonars; null if a program made it. */
    private final robosim.geometry.world.@Nullable World file;

    /** Null as long as nothing has a body. */
    private @Nullable Bodies bodies;

    private final List<BodyRequest> inFile;

    RobotWorld(Geometry geometry, robosim.geometry.world.@Nullable World file, VirtualClock clock) {
        this.geometry = geometry;
        this.file = file;
        this.inFile = file == null ? List.of() : WorldBodies.of(file);
        this.clock = clock;
        this.watches = new Watches(geometry, clock);
        this.transcript = new Transcript(geometry);
        transcript.catchUp();
    }

    private void catchUp() {
        Bodies before = bodies;
        // Asked before settling, which puts other objects in their places.
        StepBundle anew = before != null && transcript.isBehind() ? before.anew() : null;
        if (anew != null) {
            settle();
        }
        transcript.catchUp();
        if (before != null && anew != null) {
            bodies = before.again(new BodyStepper(geometry));
            run(bodies, anew);
        }
    }

    /**
     * Drops what poses keep beyond the bits that a recorded world has: what rounding took from the sums of many moves. Else a
     * replay, which begins with the recorded world, would be off in the last bit.
     */
    private void settle() {
        for (GeometryObject object : geometry.objects()) {
            Pose pose = object.pose();
            if (object.isMoveable() && object.name() != null) {
                remove(object);
                geometry.addObjectUnchecked(object.at(Pose.of(pose.center(), pose.rotation(), pose.heading(), 0)));
            }
        }
    }

    /** Removes an object with all that is attached to it. */
    private void remove(GeometryObject object) {
        geometry.removeObject(String.valueOf(object.name()));
        if (object instanceof ObjectGroup group) {
            group.loads().forEach(this::remove);
        }
    }

    private Bodies bodies() {
        catchUp();
        Bodies all = bodies;
        if (all == null) {
            all = new Bodies(new BodyStepper(geometry));
            bodies = all;
            clock.moving(this::step);
            if (!inFile.isEmpty()) {
                run(all, new StepBundle(0, inFile, List.of()));
                inFile.forEach(all::give);
            }
        }
        return all;
    }

    /** Carries out a step; fails if a body or a command cannot be given. */
    private void run(Bodies all, StepBundle step) {
        Reply reply = all.run(step, clock.steps());
        transcript.stepped(step, reply, clock.steps());
        if (!reply.problems().isEmpty()) {
            throw new IllegalArgumentException(reply.problems().get(0).reason());
        }
    }

    private void step() {
        Bodies all = bodies();
        run(all, all.next(clock.step().toNanos() / 1e9));
        watches.check(meetings());
    }

    BodyRequest body(String name) {
        return bodies().of(name);
    }

    void give(BodyRequest body) {
        Bodies all = bodies();
        run(all, new StepBundle(0, List.of(body), List.of()));
        all.give(body);
    }

    /** Tells a robot to drive, from the next step on; the turn is degrees, or newton metres for a force. */
    void tell(String name, double forward, double right, double turn) {
        Bodies all = bodies();
        DriveSettings drive = all.of(name).drive();
        Kind kind = (drive == null ? DriveSettings.DEFAULT : drive).kind();
        all.tell(new DriveCommand(name, forward, right, kind.turn(turn)));
    }

    /** Pushes an object in the next step. */
    void push(PushRequest push) {
        bodies().push(push);
    }

    /** Where a body was after the last step, and its velocity; null if it is not a body. */
    @Nullable
    BodyAnswer answer(String name) {
        return bodies().answer(name);
    }

    /** What a body touched in the last step. */
    List<ContactAnswer> contacts(String name) {
        return bodies().contacts(name);
    }

    /** Lets time pass. */
    void elapse(double seconds) {
        double step = clock.step().toNanos() / 1e9;
        double steps = Math.rint(seconds / step);
        Checks.refuse(
                !(seconds >= 0 && Math.abs(steps * step - seconds) <= 1e-9 * (1 + seconds) && steps <= MOST_STEPS),
                "seconds must be a multiple of the clock's step of " + step + " s, of at most " + MOST_STEPS + " steps",
                seconds);
        bodies();
        clock.advance((int) steps);
    }

    /** What bodies met so far, in order. */
    List<Bodies.Meeting> meetings() {
        Bodies all = bodies;
        return all == null ? List.of() : all.meetings();
    }

    /** What a body met so far, without what it stands on. */
    List<Bodies.Meeting> met(String name) {
        return meetings().stream()
                .filter(meeting -> meeting.isOf(name) && !watches.isGround(meeting))
                .toList();
    }

    /** What a body met, for a message. */
    String words(Bodies.Meeting meeting, String name) {
        return watches.other(meeting, name);
    }

    boolean isBody(String name) {
        Bodies all = bodies;
        return all != null && all.has(name);
    }

    void checkNear(String kind, String name, double x, double z, double within) {
        Robot.check("within", within);
        Point at = known(name).center();
        double dx = at.x() - x;
        double dz = at.z() - z;
        double off = Math.sqrt(dx * dx + dz * dz);
        if (!(off <= within)) {
            throw new AssertionFailedError(kind + " " + Text.quoted(name) + " was to be within "
                    + FailureFormat.number(within)
                    + " of (" + FailureFormat.number(x) + ", " + FailureFormat.number(z) + ")" + moment() + ", but is "
                    + FailureFormat.apart(off, within) + " away; it stands " + FailureFormat.place(known(name))
                    + lastHindrance(name));
        }
    }

    /** For tests without the extension; a step of its clock is a tenth of a second. */
    public static RobotWorld of(Geometry geometry) {
        Checks.present("geometry", geometry);
        return new RobotWorld(geometry, null, new VirtualClock(Duration.ofMillis(100)));
    }

    /**
     * A world from a file, for tests without the extension, as {@link #of(Geometry)}: its robots have their own sonars,
     * and pictures have its colours and its unit.
     *
     * @throws IllegalArgumentException if an object extends beyond the world's bounds
     */
    public static RobotWorld from(robosim.geometry.world.World world) {
        Checks.present("world", world);
        return new RobotWorld(world.toGeometry(), world, new VirtualClock(Duration.ofMillis(100)));
    }

    /** The world itself; changes to it affect the robots. */
    public Geometry geometry() {
        return geometry;
    }

    /** Its clock. */
    public VirtualClock clock() {
        return clock;
    }

    /**
     * A robot.
     *
     * @throws IllegalArgumentException if there is no moveable object of that name; the message lists those that exist,
     *     of many the closest
     */
    public Robot robot(String name) {
        Checks.present("name", name);
        if (!geometry.hasObject(name) || !geometry.getObject(name).isMoveable()) {
            throw new IllegalArgumentException("name must be that of a moveable object, "
                    + Text.choice(name, names(true)) + " (got: " + Text.quoted(name) + ")");
        }
        return robots.computeIfAbsent(name, each -> new Robot(this, each));
    }

    /**
     * An object, to give it a mass, so that robots push it.
     *
     * @throws IllegalArgumentException if there is none of that name; the message lists those that exist
     */
    public Robot object(String name) {
        Checks.present("name", name);
        known(name);
        return new Robot(this, "object", name);
    }

    /** All moveable objects, in the order in which they were added. */
    public List<Robot> robots() {
        List<Robot> all = new ArrayList<>();
        for (GeometryObject object : geometry.objects()) {
            String name = object.name();
            if (object.isMoveable() && name != null) {
                all.add(robot(name));
            }
        }
        return all;
    }

    /** What was done so far, as a scenario that ends with the present world. */
    public Scenario scenario(String title) {
        Checks.present("title", title);
        return transcript.scenario(title);
    }

    private List<String> names(boolean moveable) {
        return geometry.objects().stream()
                .filter(object -> object.name() != null && (!moveable || object.isMoveable()))
                .map(object -> String.valueOf(object.name()))
                .toList();
    }

    GeometryObject known(String name) {
        if (!geometry.hasObject(name)) {
            throw new IllegalArgumentException("name must be that of an object, " + Text.choice(name, names(false))
                    + " (got: " + Text.quoted(name) + ")");
        }
        return geometry.getObject(name);
    }

    /** The distance of two objects, as a bracket. */
    Verdict distance(String name, String other) {
        return ContactQuery.distance(known(name), known(other), geometry.dimension(), Budget.UNLIMITED);
    }

    MoveResult move(String name, Move move) {
        catchUp();
        MoveRequest request = new MoveRequest(
                name, move.x(), move.y(), move.z(), Degrees.toRadians(move.rx()), Degrees.toRadians(move.ry()));
        Move asked = new Move(
                move.x(), move.y(), move.z(), Degrees.toDegrees(request.rx()), Degrees.toDegrees(request.ry()));
        MoveResult result = geometry.move(name, asked);
        String refusal = result.allowed() ? null : FailureFormat.blocked(move, result);
        transcript.moved(request, refusal, clock.steps());
        if (refusal != null) {
            GeometryObject obstacle = result.obstacle();
            watches.refused(
                    name,
                    obstacle == null ? null : obstacle.name(),
                    "robot " + Text.quoted(name) + " was to " + FailureFormat.move(move),
                    refusal + "; it stands " + FailureFormat.place(known(name)));
        }
        watches.check(meetings());
        return result;
    }

    double measure(String name, double degrees) {
        return measure(name, Degrees.cos(degrees), -Degrees.sin(degrees), Beam.LINE);
    }

    /** Measures as a peer does whose beam it is, with the opening angle in radians. */
    double measure(String name, double x, double z, Beam beam) {
        catchUp();
        double distance =
                geometry.getSonarDistance(name, x, z, beam.min(), beam.max(), Degrees.toDegrees(beam.width()));
        transcript.measured(name, x, z, beam, distance, clock.steps());
        return distance;
    }

    /** The sonars that the world's file gives a robot. */
    List<SonarRing> sonars(String name) {
        return file == null
                ? List.of()
                : file.objects().stream()
                        .filter(each -> name.equals(each.object().name()))
                        .flatMap(each -> each.sonars().stream())
                        .toList();
    }

    /** The file that it came from; null if a program made it. */
    robosim.geometry.world.@Nullable World file() {
        return file;
    }

    /** Watches that two objects never touch, from now on and in what happened so far. */
    void watch(String robot, String other) {
        known(other);
        Checks.refuse(robot.equals(other), "other must not be the robot itself", Text.quoted(other));
        watches.add(robot, other, meetings());
    }

    /** Watches that a robot touches nothing but some objects, from now on and in what happened so far. */
    void watch(String robot, Set<String> except) {
        except.forEach(this::known);
        watches.add(robot, except, meetings());
    }

    /** What last hindered the robot, a refused move or a stop in a step, for a message; empty where there is nothing. */
    String lastHindrance(String name) {
        Bodies all = bodies;
        return watches.lastRefusal(name) + (all == null ? "" : all.lastStop(name));
    }

    /** Sets the goal that a robot is to reach; null for none. */
    void seek(@Nullable Goal goal) {
        sought = goal;
    }

    /** The goal that is not reached yet, as objects at its place; empty if there is none. */
    List<GeometryObject> goals() {
        return sought == null ? List.of() : sought.objects(geometry);
    }

    /** The present step of the clock, for a message; empty before the first step. */
    String moment() {
        return clock.steps() == 0 ? "" : " in step " + clock.steps();
    }
}

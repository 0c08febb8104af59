package robosim.geometry.net.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Text;
import robosim.geometry.dynamics.AckermannDrive;
import robosim.geometry.dynamics.Body;
import robosim.geometry.dynamics.BodyContact;
import robosim.geometry.dynamics.DifferentialDrive;
import robosim.geometry.dynamics.Drive;
import robosim.geometry.dynamics.Dynamics;
import robosim.geometry.dynamics.ForceDrive;
import robosim.geometry.dynamics.OmnidirectionalDrive;
import robosim.geometry.dynamics.StepResult;
import robosim.geometry.dynamics.Surface;
import robosim.geometry.dynamics.SwerveDrive;
import robosim.geometry.dynamics.VelocityDrive;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;
import robosim.geometry.protocol.StepBundle;
import robosim.geometry.protocol.batch.Numbers;
import robosim.geometry.protocol.motion.BodyAnswer;
import robosim.geometry.protocol.motion.BodyRequest;
import robosim.geometry.protocol.motion.ContactAnswer;
import robosim.geometry.protocol.motion.DriveCommand;
import robosim.geometry.protocol.motion.DriveSettings;
import robosim.geometry.protocol.motion.PushRequest;
import robosim.geometry.protocol.motion.StopAnswer;
import robosim.geometry.protocol.motion.SurfaceMixing;
import robosim.geometry.protocol.motion.SurfaceSettings;
import robosim.geometry.protocol.motion.SwerveSettings;
import robosim.geometry.protocol.motion.Velocity;

/** The bodies of one world, which steps move. Made when the first step is asked for: a world without one pays nothing. */
public final class BodyStepper {
    /** Most bodies of a world: the largest swarm tried has 10,000 robots. */
    public static final int MAX_BODIES = 10_000;

    /** The angle of a car's front wheels if nobody limits it, degrees: about twice that of a real one. */
    private static final double CAR_STEERING = 60;

    private final Geometry world;
    private final Dynamics dynamics;

    /** The bodies in the order in which they became such, and what drives each. */
    private final Set<String> bodies = new LinkedHashSet<>();

    private final Map<String, DriveSettings> drives = new HashMap<>();

    /** What was given last, of static objects too. */
    private final Map<String, BodyRequest> requests = new LinkedHashMap<>();

    private @Nullable SurfaceMixing mixing;
    private final Runnable breath;

    /** Null where nothing falls. */
    private final @Nullable FallDetector falls;

    /** No bodies so far, and nothing that runs between two parts of a step. */
    public BodyStepper(Geometry world) {
        this(world, () -> {});
    }

    /**
     * No bodies so far.
     *
     * @param breath runs between two parts of a step, so that a long one cannot keep others waiting
     * @throws IllegalArgumentException if bodies cannot move in such a world
     */
    public BodyStepper(Geometry world, Runnable breath) {
        this.world = world;
        this.breath = breath;
        this.dynamics = new Dynamics(world);
        dynamics.pausing(breath);
        falls = world.dimension() == Dimension.SPATIAL ? new FallDetector(world) : null;
    }

    /** By body, the fall that ended in the last step, onto the lower border of the world or something static. */
    public Map<String, FallDetector.Fall> falls() {
        return falls == null ? Map.of() : Collections.unmodifiableMap(falls.last());
    }

    /**
     * Carries out a step.
     *
     * @param refused takes the number of a body or command, bodies counted first, and why it was refused; the rest is carried
     *     out
     * @throws RuntimeException of whatever ends it, as a limit does; the world and its bodies are then as before
     */
    public StepBundle.Answer step(StepBundle step, BiConsumer<Integer, String> refused) {
        boolean isChange = step.size() > 0;
        List<String> bodiesBefore = isChange ? List.copyOf(bodies) : List.of();
        Map<String, DriveSettings> drivesBefore = isChange ? Map.copyOf(drives) : Map.of();
        Map<String, BodyRequest> givenBefore = isChange ? new LinkedHashMap<>(requests) : Map.of();
        boolean isMade = false;
        try {
            StepBundle.Answer answer = dynamics.together(() -> carryOut(step, refused));
            isMade = true;
            mixing = step.mixing() == null ? mixing : step.mixing();
            return answer;
        } finally {
            if (isChange && !isMade) {
                bodies.clear();
                bodies.addAll(bodiesBefore);
                drives.clear();
                drives.putAll(drivesBefore);
                requests.clear();
                requests.putAll(givenBefore);
            }
        }
    }

    private StepBundle.Answer carryOut(StepBundle step, BiConsumer<Integer, String> refused) {
        bodies.removeIf(name -> !dynamics.has(name));
        drives.keySet().retainAll(bodies);
        if (falls != null) {
            falls.begin();
        }
        SurfaceMixing rules = step.mixing();
        if (rules != null) {
            dynamics.mix(rule(rules.restitution()), rule(rules.friction()));
        }
        int index = 0;
        for (BodyRequest body : step.bodies()) {
            attempt(index++, body.objectName(), refused, () -> add(body));
        }
        for (DriveCommand command : step.commands()) {
            attempt(index++, command.objectName(), refused, () -> command(command));
        }
        for (PushRequest push : step.pushes()) {
            attempt(index++, push.objectName(), refused, () -> push(push));
        }
        if (step.seconds() == 0 || bodies.isEmpty()) {
            return new StepBundle.Answer(places(), List.of(), List.of());
        }
        StepResult result = dynamics.step(step.seconds());
        if (falls != null) {
            falls.end(result);
        }
        List<ContactAnswer> contacts =
                new ArrayList<>(result.contacts().size() + result.ended().size());
        result.contacts().forEach(contact -> contacts.add(answer(contact)));
        result.ended().forEach(contact -> contacts.add(answer(contact)));
        List<StopAnswer> stops =
                result.stops().stream().map(BodyStepper::answer).toList();
        return new StepBundle.Answer(places(), contacts, result.stopped(), stops);
    }

    private static Surface.Mixing rule(SurfaceMixing.Rule rule) {
        return switch (rule) {
            case GEOMETRIC_MEAN -> Surface.Mixing.GEOMETRIC_MEAN;
            case MEAN -> Surface.Mixing.MEAN;
            case LARGER -> Surface.Mixing.LARGER;
            case SMALLER -> Surface.Mixing.SMALLER;
            case PRODUCT -> Surface.Mixing.PRODUCT;
        };
    }

    private static StopAnswer answer(StepResult.Stop stop) {
        StopAnswer.Reason reason = switch (stop.reason()) {
            case COLLISIONS -> StopAnswer.Reason.COLLISIONS;
            case BLOCKED -> StopAnswer.Reason.BLOCKED;
            case OVERLAP -> StopAnswer.Reason.OVERLAP;
        };
        return new StopAnswer(stop.body(), reason, stop.other());
    }

    private ContactAnswer answer(BodyContact contact) {
        ContactAnswer.Phase phase = switch (contact.phase()) {
            case BEGIN -> ContactAnswer.Phase.BEGIN;
            case LAST -> ContactAnswer.Phase.LAST;
            case END -> ContactAnswer.Phase.END;
        };
        return new ContactAnswer(
                contact.body(),
                contact.other(),
                contact.point(),
                contact.normal(),
                contact.impulse(),
                phase,
                falls == null ? 0 : falls.endedBy(contact));
    }

    private void attempt(int index, String name, BiConsumer<Integer, String> refused, Runnable what) {
        breath.run();
        if (!world.hasObject(name)) {
            refused.accept(index, "no object " + Text.quoted(name));
            return;
        }
        try {
            what.run();
        } catch (IllegalArgumentException e) {
            refused.accept(index, Text.line(String.valueOf(e.getMessage())));
        }
    }

    private void add(BodyRequest asked) {
        GeometryObject object = ObjectGroup.withoutLoads(world.getObject(asked.objectName()));
        SurfaceSettings given = asked.surface();
        Surface surface = new Surface(given.restitution(), given.staticFriction(), given.slidingFriction());
        if (!object.isMoveable()
                && asked.equals(BodyRequest.of(asked.objectName()).withSurface(given))) {
            dynamics.surface(asked.objectName(), surface);
            requests.put(asked.objectName(), asked);
            return;
        }
        if (!object.isMoveable()) {
            throw new IllegalArgumentException("a static object must have a surface alone (got: " + asked + ")");
        }
        checkCount(asked.objectName());
        Velocity velocity = asked.velocity();
        if (velocity != null && velocity.y() != 0 && world.dimension() == Dimension.PLANAR) {
            throw new IllegalArgumentException(
                    "velocity must have no part upwards in a PLANAR world; set y to 0 (got: " + velocity + ")");
        }
        Body body = BodyRequests.body(object, asked.mass(), asked.inertia())
                .withSurface(surface)
                .withDamping(asked.damping(), asked.turnDamping())
                .withLimits(asked.maxSpeed(), degrees(asked.maxTurn()))
                .withFloorFriction(asked.floorFriction())
                .withDrag(asked.drag(), asked.rolling())
                .ignoring(asked.ignored());
        // All that may be refused is made before anything is changed, so that what is refused leaves nothing behind.
        String name = asked.objectName();
        DriveSettings settings = asked.drive();
        Drive drive = settings == null || settings.kind() == DriveSettings.Kind.NONE
                ? null
                : drive(object, settings, new DriveCommand(name, 0, 0, 0));
        Twist going = velocity == null
                ? null
                : new Twist(velocity.x(), velocity.y(), velocity.z(), Degrees.toDegrees(velocity.ry()));
        dynamics.add(name, body);
        bodies.add(name);
        requests.put(name, asked);
        if (falls != null) {
            falls.watch(name);
        }
        if (settings != null && settings.kind() == DriveSettings.Kind.NONE) {
            drives.remove(name);
            dynamics.clearDrive(name);
        } else if (settings != null && drive != null) {
            drives.put(name, settings);
            dynamics.drive(name, drive);
        }
        if (going != null) {
            dynamics.setVelocity(name, going);
        }
    }

    private void checkCount(String name) {
        if (bodies.size() >= MAX_BODIES && !bodies.contains(name)) {
            throw new IllegalArgumentException("a world must have at most " + MAX_BODIES + " bodies (got: one more)");
        }
    }

    private void command(DriveCommand command) {
        String name = command.objectName();
        DriveSettings settings = drives.getOrDefault(name, DriveSettings.DEFAULT);
        DriveSettings.Kind kind = settings.kind();
        if (command.right() != 0 && !kind.canGoSideways()) {
            throw new IllegalArgumentException("right must be 0 for a drive of kind " + kind
                    + "; give " + Text.quoted(name)
                    + " a body with a drive of kind OMNIDIRECTIONAL, SWERVE, VELOCITY or FORCE (got: "
                    + command.right() + ")");
        }
        if (kind == DriveSettings.Kind.ACKERMANN && !(Math.abs(command.turn()) < Math.PI / 2)) {
            throw new IllegalArgumentException("turn of a car must be an angle of its front wheels between -pi/2 and"
                    + " pi/2, in radians (got: " + command.turn() + ")");
        }
        GeometryObject object = ObjectGroup.withoutLoads(world.getObject(name));
        if (!object.isMoveable()) {
            throw new IllegalArgumentException(
                    "objectName must be that of a moveable object (got: " + Text.quoted(name) + ")");
        }
        Drive drive = drive(object, settings, command);
        if (!bodies.contains(name)) {
            add(BodyRequest.of(name));
        }
        drives.put(name, settings);
        dynamics.drive(name, drive);
    }

    private void push(PushRequest push) {
        String name = push.objectName();
        GeometryObject object = world.getObject(name);
        if (!object.isMoveable()) {
            throw new IllegalArgumentException(
                    "objectName must be that of a moveable object (got: " + Text.quoted(name) + ")");
        }
        if (!bodies.contains(name)) {
            add(BodyRequest.of(name));
        }
        Point given = push.at();
        Point at = given == null ? object.center() : given;
        Point impulse = push.impulse();
        Point force = push.force();
        if (impulse != null) {
            dynamics.applyImpulse(name, impulse, at);
        }
        if (force != null) {
            dynamics.applyForce(name, force, at);
        }
    }

    private Drive drive(GeometryObject object, DriveSettings drive, DriveCommand command) {
        double turn = Degrees.toDegrees(command.turn());
        Bounds box = object.turned(0, -object.heading()).bounds();
        return switch (drive.kind()) {
            case DIFFERENTIAL ->
                new DifferentialDrive(
                                drive.base() == 0 ? box.length() : drive.base(),
                                drive.maxSpeed(),
                                drive.maxAcceleration())
                        .driving(command.forward(), turn);
            case OMNIDIRECTIONAL ->
                new OmnidirectionalDrive(
                                drive.maxSpeed(),
                                drive.maxAcceleration(),
                                degrees(drive.maxTurn()),
                                degrees(drive.maxTurnAcceleration()))
                        .driving(command.forward(), command.right(), turn);
            case ACKERMANN ->
                new AckermannDrive(
                                drive.base() == 0 ? box.width() : drive.base(),
                                drive.maxTurn() == Double.POSITIVE_INFINITY ? CAR_STEERING : degrees(drive.maxTurn()),
                                drive.maxSpeed(),
                                drive.maxAcceleration())
                        .withCentreAhead(drive.centreAhead())
                        .driving(command.forward(), turn);
            case VELOCITY -> new VelocityDrive(new Twist(command.forward(), 0, command.right(), turn));
            case FORCE -> new ForceDrive(command.forward(), command.right(), command.turn());
            case SWERVE -> swerve(object, drive.swerve()).driving(command.forward(), command.right(), turn);
            case NONE -> throw new IllegalStateException("kind NONE must be handled before drives are made");
        };
    }

    /** A swerve drive, its modules at the angles that they have, so that each turns the shorter way. */
    private SwerveDrive swerve(GeometryObject object, @Nullable SwerveSettings asked) {
        Bounds box = object.turned(0, -object.heading()).bounds();
        SwerveDrive made =
                asked == null ? SwerveDrive.of(box.width(), box.length(), null, 1) : BodyRequests.swerve(asked);
        String name = String.valueOf(object.name());
        @Nullable Drive old = dynamics.has(name) ? dynamics.drive(name) : null;
        if (!(old instanceof SwerveDrive before)
                || before.modules().size() != made.modules().size()) {
            return made;
        }
        List<SwerveDrive.Module> turned = new ArrayList<>();
        for (int k = 0; k < made.modules().size(); k++) {
            turned.add(made.modules().get(k).to(before.modules().get(k).angle(), 0));
        }
        return made.with(turned);
    }

    /** What kind of drive an object has or, without a body, would get. */
    DriveSettings.Kind kind(String name) {
        return drives.getOrDefault(name, DriveSettings.DEFAULT).kind();
    }

    /** A step of no time that gives the same bodies and surfaces to another world. */
    StepBundle given() {
        List<BodyRequest> present = requests.values().stream()
                .filter(each -> world.hasObject(each.objectName()))
                .toList();
        return new StepBundle(0, present, List.of(), mixing);
    }

    /** Whether an object has a body. */
    public boolean has(String name) {
        return dynamics.has(name);
    }

    private static double degrees(double radians) {
        return radians == Double.POSITIVE_INFINITY ? radians : Degrees.toDegrees(radians);
    }

    private List<BodyAnswer> places() {
        List<BodyAnswer> places = new ArrayList<>(bodies.size());
        for (String name : bodies) {
            breath.run();
            GeometryObject object = world.getObject(name);
            Twist velocity = dynamics.velocity(name);
            places.add(new BodyAnswer(
                    name,
                    object.center(),
                    Degrees.toRadians(object.heading()),
                    object.pose().isUpright() ? Numbers.NONE : new Numbers(object.rotation()),
                    new Velocity(velocity.x(), velocity.y(), velocity.z(), Degrees.toRadians(velocity.ry()))));
        }
        return places;
    }
}

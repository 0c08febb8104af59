package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.check.Checks;
import robosim.geometry.dynamics.planar.PlanarStepper;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.IgnoredPairs;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;

/**
 * Bodies that move, push and bounce, and never overlap anything: each step goes from collision to collision. In a PLANAR world
 * they drive and slide on the floor, in a SPATIAL one they fall, tip and roll, and drive over what they stand on.
 *
 * <pre>{@code
 * Geometry world = new Geometry(20, 5, 20, Dimension.PLANAR, Accuracy.EXACT);
 * world.addObject(new CylinderObject(new Point(-3, 0, 0), 0.5, 1).moveable("a"));
 * world.addObject(new CylinderObject(new Point(3, 0, 0), 0.5, 1).moveable("b"));
 * Dynamics dynamics = new Dynamics(world, Surface.SMOOTH);
 * dynamics.add("a", Body.of(2, 1).withSurface(new Surface(1, 0, 0)));
 * dynamics.add("b", Body.of(2, 1).withSurface(new Surface(1, 0, 0)));
 * dynamics.setVelocity("a", new Twist(4, 0, 0, 0));
 * dynamics.step(2).contacts().get(0).other();       // "b"
 * Math.round(dynamics.velocity("b").x() * 1e6);     // 4000000: the same disc at rest takes all of it
 * }</pre>
 *
 * <p>Who meets when, translating and turning, is found with plain doubles; then those go whose ways are proved to keep apart,
 * and the others as far as swept moves that are exact let them, so that nothing overlaps and nothing passes through anything.
 * Bodies stop {@code 1e-10} metres before contact. What has no body stands still, moveable or not. The world may be changed
 * between steps. A body belongs to its object: with the object it goes, and another object of that name has none. Not thread-safe, like the world.
 *
 * <p>In a PLANAR world, bodies whose objects are {@linkplain Geometry#attach(String, String) attached} to each other are one: their
 * masses, moments of inertia and momenta are added up when they are attached, and what is detached goes on as fast as its place
 * went.
 *
 * <p>In a SPATIAL world spheres, boxes, cylinders and capsules can be bodies, and gravity pulls them. A step goes by slices of
 * a millisecond; what is decided along a way that turns, and how, is told in {@code docs/dynamics.md}.
 *
 * <pre>{@code
 * Geometry room = new Geometry(20, 20, 20, Dimension.SPATIAL, Accuracy.EXACT);
 * room.addObject(new BoxObject(new Point(0, -0.5, 0), 20, 1, 20).named("floor"));
 * room.addObject(new SphereObject(new Point(0, 2, 0), 0.5).moveable("ball"));
 * Dynamics falling = new Dynamics(room, new Surface(0.5, 0.5, 0.4));
 * falling.add("ball", Body.ofMass(room.getObject("ball"), 1).withSurface(new Surface(0.5, 0.5, 0.4)));
 * falling.step(10);
 * Math.round(room.getObject("ball").center().y() * 1e6);  // 500000: at rest on the floor
 * }</pre>
 */
public final class Dynamics {
    /** Drives, damping and the floor's friction are worked out anew after so many seconds at most. */
    private static final double SLICE = 1.0 / 16;

    /** What is not round turns by no more than so many radians before it goes on. */
    private static final double TURN = 0.5;

    /** Most parts of a step: an hour and more. In a longer step each part is longer. */
    private static final int MOST_SLICES = 1 << 16;

    /** What turns divides each 4 seconds, or a shorter step, into so many parts at most. */
    private static final int MOST_TURNS = 64;

    /** The friction of a ground of which nothing is known, about that of wood. */
    private static final double FRICTION = 0.5;

    private static final Point DOWN = new Point(0, -Body.GRAVITY, 0);

    private final Geometry world;
    private final Map<String, BodyState> bodies = new LinkedHashMap<>();

    /** Joins the bodies of objects that are attached to each other. */
    private final AttachedBodies attached;

    private final World engine;
    private final ObjectTable objects;
    private final PlanarStepper stepper;
    private final SurfaceTable table;

    /** Null in a PLANAR world. */
    private final @Nullable SpatialBodies falling;

    /** The bodies by their index in the stepper; objects that only stand in the way come after them. */
    private final List<BodyState> order = new ArrayList<>();

    private final PlanarStepper.Pushes pushes = this::push;
    private boolean isStale = true;

    /** How often the stepper has been given all bodies. */
    private long prepared;

    /** Whether it was last given those of a step that was taken back, but remembers what these bodies did before it. */
    private boolean isTakenBack;

    /** Whether a body has three moments of inertia, of which its attitude makes one. */
    private boolean hasMoments;

    /** Runs between two parts of the work. */
    private Runnable betweenParts = () -> {};

    /** Whether what runs then may end a step. */
    private boolean isPausing;

    /** Whether what a step changes has been kept, so that it can be taken back. */
    private boolean isKept;

    /** Whether the step at hand has begun. */
    private boolean hasBegun;

    /**
     * Bodies in a world, none so far. What has no body is smooth in a PLANAR world, and has a friction of 0.5 in a SPATIAL
     * one, where bodies stand and drive on it.
     *
     * @throws IllegalArgumentException if heights count in the world and its accuracy is not {@code EXACT}
     */
    public Dynamics(Geometry world) {
        this(
                world,
                Checks.present("world", world).dimension() == Dimension.SPATIAL
                        ? new Surface(0, FRICTION, FRICTION)
                        : Surface.SMOOTH);
    }

    /**
     * Bodies in a world, none so far.
     *
     * @param ground the surface of all that has no body
     * @throws IllegalArgumentException if heights count in the world and its accuracy is not {@code EXACT}
     */
    public Dynamics(Geometry world, Surface ground) {
        this(world, ground, DOWN, Checks.present("world", world).dimension() == Dimension.SPATIAL);
    }

    /**
     * Bodies in a SPATIAL world, none so far.
     *
     * @param ground  the surface of all that has no body
     * @param gravity m/s<sup>2</sup> along the world's axes; where none is given, {@link Body#GRAVITY} downward
     * @throws IllegalArgumentException if the world is PLANAR, or its accuracy is not {@code EXACT}
     */
    public Dynamics(Geometry world, Surface ground, Point gravity) {
        this(world, ground, Checks.present("gravity", gravity), true);
    }

    private Dynamics(Geometry world, Surface ground, Point gravity, boolean falls) {
        this.world = Checks.present("world", world);
        Checks.present("ground", ground);
        if (falls && world.dimension() != Dimension.SPATIAL) {
            throw new IllegalArgumentException(
                    "world must be SPATIAL where gravity is given (got: " + world.dimension() + ")");
        }
        engine = world.engine();
        objects = engine.objects;
        attached = new AttachedBodies(engine, bodies);
        stepper = new PlanarStepper(engine);
        table = new SurfaceTable(ground);
        falling = falls ? new SpatialBodies(engine, table, gravity) : null;
        pauseBy(() -> {});
    }

    /**
     * Gives a moveable object of the world a body, at rest; or another body, which keeps its velocity.
     *
     * @throws IllegalArgumentException if no object and no layer has a name that the body ignores
     */
    public void add(String name, Body body) {
        GeometryObject object = world.getObject(name);
        Checks.present("body", body);
        if (!object.isMoveable()) {
            throw new IllegalArgumentException("name must be that of a moveable object (got: \"" + name + "\")");
        }
        if (falling != null) {
            SpatialBodies.check(object);
        }
        engine.registry.ignore(body.ignored()); // refuses names that are not there
        objects.ignored.clear();
        BodyState before = find(name);
        attached.disband();
        BodyState state = new BodyState(name, body, engine);
        bodies.put(name, state);
        if (before != null) {
            state.vx = before.vx;
            state.vz = before.vz;
            state.w = before.w;
            state.driveAs(before);
            System.arraycopy(before.spatial, 0, state.spatial, 0, before.spatial.length);
        }
        isStale = true;
    }

    /** Takes the body from an object, which from then on stands still; answers whether it had one. */
    public boolean remove(String name) {
        boolean hadOne = find(name) != null;
        attached.disband();
        bodies.remove(name);
        isStale = true;
        return hadOne;
    }

    /** Gives an object without a body a surface of its own, instead of that given for all. */
    public void surface(String name, Surface surface) {
        world.getObject(name);
        table.give(objects, name, Checks.present("surface", surface));
        isStale = true;
    }

    /**
     * Sets how the surfaces of two objects make that of their contact; both are {@link Surface.Mixing#GEOMETRIC_MEAN} unless told
     * otherwise.
     */
    public void mix(Surface.Mixing restitution, Surface.Mixing friction) {
        table.mix(Checks.present("restitution", restitution), Checks.present("friction", friction));
        isStale = true;
    }

    /**
     * Drives a body from now on. In a SPATIAL world a drive acts while the body stands on something, within what friction can
     * give there: the body's own friction is that of its surface, or {@link Body#floorFriction} if that is more. The drive of a body
     * that is attached to another one waits until it is detached.
     */
    public void drive(String name, Drive drive) {
        BodyState state = state(name);
        Checks.present("drive", drive);
        if (drive instanceof VelocityDrive of) {
            QuantityChecks.level("drive", of.velocity(), "where it acts along the ground");
        }
        state.drive(drive);
    }

    /** What drives a body, the modules of a {@link SwerveDrive} at the angles that they have come to; null for nothing. */
    public @Nullable Drive drive(String name) {
        return state(name).drive;
    }

    /** Takes the drive from a body, which then goes on by itself; answers whether it had one. */
    public boolean clearDrive(String name) {
        BodyState state = state(name);
        boolean hadOne = state.drive != null;
        state.drive(null);
        return hadOne;
    }

    /** Gives a body an impulse through its centre, at once: {@link #applyImpulse(String, Point, Point)}. */
    public void applyImpulse(String name, Point impulse) {
        applyImpulse(name, impulse, world.getObject(name).center());
    }

    /**
     * Gives a body an impulse at once, as a kick does: its velocity changes by the impulse over the mass, and its turn by the
     * torque about its centre. A drive acts against that in the next step, as far as its limits allow.
     *
     * @param impulse newton seconds along the world's axes; level in a PLANAR world
     * @param at      where it acts, on the body or not, in the world; its height does not count in a PLANAR world
     */
    public void applyImpulse(String name, Point impulse, Point at) {
        BodyState state = attached.whole(state(name));
        double[] by = push("impulse", state.name, impulse, at);
        if (falling != null) {
            SpatialBodies.give(state, world.getObject(state.name), by);
            return;
        }
        int place = objects.place(objects.find(state.name));
        state.kick(by, objects.places(), place);
    }

    /** Lets a force act through the centre of a body in the next step: {@link #applyForce(String, Point, Point)}. */
    public void applyForce(String name, Point force) {
        applyForce(name, force, world.getObject(name).center());
    }

    /**
     * Lets a force act on a body all through the next step, and no longer, in addition to others. Its direction and its torque
     * about the centre stay the same while the body moves and turns. It acts beside a drive, whose limits do not grow: a
     * {@link VelocityDrive} does not yield to any force.
     *
     * @param force newtons along the world's axes; level in a PLANAR world
     * @param at    where it acts, as for an {@linkplain #applyImpulse impulse}
     */
    public void applyForce(String name, Point force, Point at) {
        BodyState state = attached.whole(state(name));
        state.push(push("force", state.name, force, at));
    }

    /** A push and its torque about the centre of a body, six numbers. */
    private double[] push(String what, String name, Point push, Point at) {
        Checks.present(what, push);
        Checks.present("at", at);
        if (falling == null && push.y() != 0) {
            throw new IllegalArgumentException(
                    what + " must be level in a PLANAR world; set y to 0 (got: " + push + ")");
        }
        Point centre = world.getObject(name).center();
        double x = at.x() - centre.x();
        double y = falling == null ? 0 : at.y() - centre.y();
        double z = at.z() - centre.z();
        return new double[] {
            push.x(),
            push.y(),
            push.z(),
            y * push.z() - z * push.y(),
            z * push.x() - x * push.z(),
            x * push.y() - y * push.x()
        };
    }

    /**
     * Sets the velocity of a body, along its own axes; a body with a drive gets that of the drive in the next step.
     *
     * @throws IllegalArgumentException if it has a part upwards and the world is PLANAR
     */
    public void setVelocity(String name, Twist velocity) {
        BodyState state = state(name);
        Checks.present("velocity", velocity);
        if (falling != null) {
            SpatialBodies.setTwist(state, world.getObject(name).pose(), velocity);
        } else {
            QuantityChecks.level("velocity", velocity, "in a PLANAR world");
            BodyState whole = attached.whole(state);
            Pose pose = engine.registry.attacher.part(name).pose();
            state.setVelocity(pose.heading(), pose.lostHeading(), velocity);
            whole.follow(state);
        }
    }

    /**
     * Sets the velocity of a body along and about the axes of the world.
     *
     * @throws IllegalArgumentException if the world is PLANAR
     */
    public void setSpatialVelocity(String name, SpatialVelocity velocity) {
        Checks.present("velocity", velocity);
        SpatialBodies.setVelocity(spatial(name), velocity);
    }

    /** The velocity of a body, along its own axes, and about its own Y alone. */
    public Twist velocity(String name) {
        BodyState state = state(name);
        Pose pose = engine.registry.attacher.part(name).pose();
        if (falling != null) {
            return SpatialBodies.twist(state, pose);
        }
        state.follow(attached.whole(state));
        return state.velocity(pose.heading(), pose.lostHeading());
    }

    /**
     * The velocity of a body along and about the axes of the world.
     *
     * @throws IllegalArgumentException if the world is PLANAR
     */
    public SpatialVelocity spatialVelocity(String name) {
        return SpatialBodies.velocity(spatial(name));
    }

    private BodyState spatial(String name) {
        if (falling == null) {
            throw new IllegalArgumentException("a velocity in space needs a SPATIAL world (got: a PLANAR one)");
        }
        return state(name);
    }

    /** The world whose objects have these bodies. */
    public Geometry world() {
        return world;
    }

    /** The names of all bodies, in the order in which they were added. */
    public List<String> names() {
        return bodies.values().stream()
                .filter(each -> each.isThere(engine))
                .map(each -> each.name)
                .toList();
    }

    /** Whether an object has a body. */
    public boolean has(String name) {
        return find(name) != null;
    }

    /** The body of an object. */
    public Body body(String name) {
        return state(name).body;
    }

    private BodyState state(String name) {
        BodyState state = find(name);
        if (state == null) {
            throw new IllegalArgumentException("name must be that of a body (got: \"" + name + "\")");
        }
        return state;
    }

    /** The body of the object that has a name now; null if it has none, though an earlier one of that name had. */
    private @Nullable BodyState find(String name) {
        isStale |= attached.assemble();
        BodyState state = bodies.get(Checks.present("name", name));
        if (state != null && !state.isThere(engine)) {
            bodies.remove(name);
            isStale = true;
            return null;
        }
        return state;
    }

    /**
     * Runs something between two parts of each step, very often in a long one: to give way to other work, or to end the step.
     *
     * @param between may throw, which ends the step; the world and all bodies are then as they were before it
     */
    public void pausing(Runnable between) {
        Checks.present("between", between);
        isPausing = true;
        pauseBy(between);
    }

    private void pauseBy(Runnable between) {
        betweenParts = () -> {
            engine.take();
            between.run();
        };
        stepper.pausing(betweenParts);
        if (falling != null) {
            falling.pausing(betweenParts);
        }
    }

    /**
     * Moves everything by a time in seconds. Under a {@link robosim.geometry.WorkLimit} of the world it counts as one call; where it
     * is ended, the world and all bodies are as they were before.
     */
    public StepResult step(double seconds) {
        if (isGuarded()) {
            return asOne(() -> {
                go(seconds);
                return tellLast();
            });
        }
        engine.begin("a step");
        try {
            go(seconds);
            return tellLast();
        } finally {
            engine.end();
        }
    }

    /** Moves everything by a time in seconds, and tells nothing; {@link #last} tells it. */
    public void advance(double seconds) {
        if (isGuarded()) {
            asOne(() -> {
                go(seconds);
                return null;
            });
            return;
        }
        engine.begin("a step"); // allocates nothing, unlike the above
        try {
            go(seconds);
        } finally {
            engine.end();
        }
    }

    /**
     * Makes changes of bodies and a step as one: if they end with an exception of any kind, the places of all objects, all bodies,
     * velocities, drives and surfaces, and what {@link #last} tells are as before. Under a {@link robosim.geometry.WorkLimit} of the
     * world they count as one call. No object may be added to the world or removed meanwhile.
     *
     * @param changes makes at most one step
     * @return what {@code changes} returns
     */
    public <T extends @Nullable Object> T together(Supplier<T> changes) {
        engine.begin("a step");
        @Nullable Kept kept = new Kept();
        isKept = true;
        try {
            T told = changes.get();
            kept = null;
            return told;
        } finally {
            isKept = false;
            if (kept != null) {
                kept.undo();
            }
            engine.end();
        }
    }

    /** Whether a step may be ended, and then has to leave all as it was. */
    private boolean isGuarded() {
        return isKept || isPausing || engine.isLimited();
    }

    /** Makes a step that may be ended, or leaves all as it was. */
    private <T extends @Nullable Object> T asOne(Supplier<T> step) {
        if (!isKept) {
            return together(step);
        }
        if (hasBegun) {
            throw new IllegalStateException("changes must make at most one step (got: a second)");
        }
        return step.get();
    }

    /** What was before a step that may be ended. */
    private final class Kept {
        private final double[] places = engine.placesOfMovers();
        private final List<BodyState> states = new ArrayList<>(bodies.size());
        private final List<BodyState> inOrder = List.copyOf(order);
        private final boolean wasStale = isStale;
        private final long wasPrepared = prepared;
        private final boolean wasTakenBack = isTakenBack;
        private final long wasAssembledAt = attached.assembledAt;

        Kept() {
            hasBegun = false;
            table.keep();
            bodies.values().forEach(each -> states.add(each.copy()));
            if (falling != null) {
                falling.keep();
            } else {
                stepper.keep();
            }
        }

        void undo() {
            engine.putBack(places);
            bodies.clear();
            states.forEach(each -> bodies.put(each.name, each));
            table.undo();
            isTakenBack = wasTakenBack || (!wasStale && prepared != wasPrepared);
            isStale = wasStale || prepared != wasPrepared || attached.assembledAt != wasAssembledAt;
            attached.assembledAt = wasAssembledAt;
            order.clear();
            inOrder.forEach(each -> order.add(bodies.getOrDefault(each.name, each)));
            if (falling != null) {
                falling.undo(bodies);
            } else {
                stepper.undo(hasBegun);
                isStale |= order.size()
                        != bodies.values().stream()
                                .filter(each -> each.root == null)
                                .count();
            }
        }
    }

    private void go(double seconds) {
        move(seconds);
        bodies.values().forEach(BodyState::endPush);
    }

    private void move(double seconds) {
        QuantityChecks.positive("seconds", seconds);
        hasBegun = false;
        isStale |= attached.assemble();
        if (falling != null) {
            attached.refuse();
        }
        if (bodies.isEmpty() && !isStale) {
            pass();
            return;
        }
        if (falling != null) {
            hasBegun = true;
            falling.advance(bodies, isStale, seconds);
            isStale = false;
            return;
        }
        prepare();
        takeInertia();
        hasBegun = true;
        stepper.begin();
        int parts = parts(seconds);
        for (int part = 0; part < parts; part++) {
            run(seconds / parts);
        }
    }

    /** Works out how bodies with three moments resist a turn about the vertical, as they are tipped now. */
    private void takeInertia() {
        for (int b = 0; b < order.size() && hasMoments; b++) {
            int at = objects.place(stepper.id(b)) + ObjectTable.ROTATION;
            BodyState each = order.get(b);
            if (each.isLoaded) {
                continue;
            }
            double inertia = each.body.aboutVertical(objects.places(), at);
            if (inertia != each.acting.inertia()) {
                each.acting = each.body.about(inertia);
            }
            stepper.setInertia(b, inertia);
        }
    }

    /** Makes a step in which there is nobody: contacts that have ended are told once. */
    private void pass() {
        if (falling != null) {
            falling.pass();
        } else {
            hasBegun = true;
            stepper.begin();
        }
    }

    /** Into how many parts a step is divided. */
    private int parts(double seconds) {
        boolean isMoving = false;
        boolean isForced = false;
        double turning = 0;
        double[] places = objects.places();
        for (int b = 0; b < order.size(); b++) {
            BodyState each = order.get(b);
            if (begin(b, places, seconds)) {
                isMoving = true;
                turning = Math.max(turning, stepper.isRound(b) ? 0 : each.turning());
            }
            isForced |= each.isForced();
        }
        double parts = isMoving && isForced ? seconds / SLICE : 1;
        double turns = Math.min(seconds * turning / TURN, MOST_TURNS * Math.max(1, seconds * SLICE / 0.25));
        return (int) Math.ceil(Math.min(MOST_SLICES, Math.max(parts, turns)));
    }

    /** Finds how a body is to go on; whether it moves. */
    private boolean begin(int b, double[] places, double seconds) {
        BodyState each = order.get(b);
        if (each.drive instanceof SwerveDrive) {
            betweenParts.run(); // its wheels may take a while
        }
        return each.begin(places, objects.place(stepper.id(b)) + ObjectTable.HEADING, seconds);
    }

    /** Lets all go on for a part of a step, in which drives, damping and floors act once. */
    private void run(double seconds) {
        double[] places = objects.places();
        for (int b = 0; b < order.size(); b++) {
            BodyState each = order.get(b);
            boolean isSlowed = each.isSlowed();
            each.steer(seconds);
            begin(b, places, seconds);
            stepper.setVelocity(b, each.goesX, each.goesZ, each.turns);
            stepper.setDriven(b, each.drive != null);
            stepper.setSlowing(b, isSlowed ? each.acting.slowing() : 0, isSlowed ? each.acting.spinSlowing() : 0);
        }
        stepper.run(seconds, table, pushes);
        places = objects.places();
        boolean isPressing = false;
        for (int b = 0; b < order.size(); b++) {
            int at = objects.place(stepper.id(b)) + ObjectTable.HEADING;
            boolean presses = order.get(b).end(stepper.vx(b), stepper.vz(b), stepper.w(b), places, at);
            stepper.press(b, presses);
            isPressing |= presses;
        }
        if (isPressing) {
            settle();
        }
    }

    /** Solves the contacts of bodies that have been pushed on after collisions, at the end of a part of a step. */
    private void settle() {
        for (int b = 0; b < order.size(); b++) {
            BodyState each = order.get(b);
            stepper.setVelocity(b, each.vx, each.vz, each.w);
        }
        stepper.settle();
        for (int b = 0; b < order.size(); b++) {
            order.get(b).settle(stepper.vx(b), stepper.vz(b), stepper.w(b));
        }
    }

    /** Lets a drive push on that a collision has slowed down. */
    private boolean push(int b, double angle, long round) {
        BodyState each = order.get(b);
        if (each.drive == null) {
            return false;
        }
        each.vx = stepper.vx(b);
        each.vz = stepper.vz(b);
        each.w = stepper.w(b);
        int at = objects.place(stepper.id(b)) + ObjectTable.HEADING;
        boolean isPushed = each.push(objects.places(), at, Degrees.toDegrees(angle), round);
        stepper.setVelocity(b, each.vx, each.vz, each.w);
        return isPushed;
    }

    /** Tells the stepper of all bodies again if any has come or gone, or anything else in the world. */
    private void prepare() {
        if (!isStale && !stepper.isOld()) {
            return;
        }
        bodies.values().removeIf(each -> !each.isThere(engine));
        prepared++;
        List<BodyState> earlier = isTakenBack ? List.copyOf(order) : List.of();
        if (isTakenBack) {
            stepper.keep();
        }
        stepper.clear();
        order.clear();
        hasMoments = false;
        table.begin(objects);
        Set<Integer> moved = new HashSet<>();
        for (BodyState each : bodies.values()) {
            betweenParts.run();
            if (each.root != null) {
                continue;
            }
            int id = engine.mover(each.name);
            moved.add(id);
            order.add(each);
            hasMoments |= each.body.hasMoments();
            table.put(id, each.body.surface());
            boolean isLoaded = each.isLoaded;
            double mass = isLoaded ? each.acting.mass() : each.body.mass();
            int b = stepper.add(id, mass, isLoaded ? each.acting.inertia() : each.body.inertia());
            stepper.setOffset(b, 0.0 - each.armX, 0.0 - each.armZ);
        }
        ignore(stepper.passing(), bodies.values(), objects);
        objects.moverIds().filter(id -> !moved.contains(id)).forEach(id -> stepper.add(id, 0, 0));
        stepper.build(table);
        if (isTakenBack && order.equals(earlier)) {
            stepper.recall(order.size());
        }
        isTakenBack = false;
        isStale = false;
    }

    /** Sets which objects pass through each other; bodies that are attached to others follow these. */
    static void ignore(IgnoredPairs passing, Collection<BodyState> bodies, ObjectTable objects) {
        passing.clear();
        for (BodyState each : bodies) {
            if (each.root == null) {
                passing.add(objects.find(each.name), each.body.ignored());
            }
        }
    }

    /** What happened in the last step. */
    public StepResult last() {
        engine.begin("last");
        try {
            return tellLast();
        } finally {
            engine.end();
        }
    }

    private StepResult tellLast() {
        if (falling != null) {
            return falling.last();
        }
        return StepResult.of(stepper.touches(), stepper.before(), betweenParts);
    }
}

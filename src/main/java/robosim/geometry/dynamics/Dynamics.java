package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.exact.Checks;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Twist;

/**
 * Bodies that move in a PLANAR world, push and bounce, and never overlap anything: each step goes from collision to collision,
 * found by swept motions of each body against what stands still and of each pair against each other.
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
 * <p>In a step all bodies translate at once. The turns of the step follow, each body in place, as far as that is free; a turn
 * that is blocked ends. Bodies stop {@code 1e-9} metres before contact. What has no body stands still, moveable or not, with
 * the surface given for all. The world may be changed between steps. Not thread-safe, like the world.
 */
public final class Dynamics {
    /** How far apart bodies stay that touch, metres, so that rounding does not stop what goes along. */
    private static final double GAP = 1e-9;

    /** Collisions earlier in a step are resolved again with later ones while the two are within so much of where they met. */
    private static final double NEAR = 1e-6;

    /** Collisions within so much of the rest of the step are resolved together. */
    private static final double TOGETHER = 1e-9;

    /** Most times at which collisions are resolved in a step, for each body and in all. */
    private static final int EVENTS_EACH = 64;

    private static final int EVENTS = 64;

    /** Most rounds in which the collisions of one time are resolved, one after the other. */
    private static final int ROUNDS = 64;

    private final Geometry world;
    private final Surface ground;
    private final Map<String, BodyState> bodies = new LinkedHashMap<>();

    /** Two objects of which one moves. */
    private final Geometry pair;

    /**
     * Bodies in a world, none so far.
     *
     * @param ground the surface of all that has no body
     * @throws IllegalArgumentException if heights count in the world
     */
    public Dynamics(Geometry world, Surface ground) {
        this.world = Checks.present("world", world);
        this.ground = Checks.present("ground", ground);
        if (world.dimension() != Dimension.PLANAR) {
            throw new IllegalArgumentException("world must be PLANAR (got: " + world.dimension() + ")");
        }
        pair = new Geometry(0x1p101, 0x1p101, 0x1p101, Dimension.PLANAR, world.accuracy());
    }

    /** Gives a moveable object of the world a body, at rest; or another body, which keeps its velocity. */
    public void add(String name, Body body) {
        GeometryObject object = world.getObject(name);
        Checks.present("body", body);
        if (!object.isMoveable()) {
            throw new IllegalArgumentException("name must be that of a moveable object (got: \"" + name + "\")");
        }
        BodyState state = new BodyState(name, body, object);
        BodyState before = bodies.put(name, state);
        if (before != null) {
            state.vx = before.vx;
            state.vz = before.vz;
            state.w = before.w;
            state.drive = before.drive;
        }
    }

    /** Drives a body from now on. */
    public void drive(String name, Drive drive) {
        state(name).drive = Checks.present("drive", drive);
    }

    /** Sets the velocity of a body, along its own axes; a body with a drive gets that of the drive in the next step. */
    public void setVelocity(String name, Twist velocity) {
        state(name).setVelocity(Checks.present("velocity", velocity));
    }

    /** The velocity of a body, along its own axes. */
    public Twist velocity(String name) {
        return state(name).velocity();
    }

    private BodyState state(String name) {
        BodyState state = bodies.get(Checks.present("name", name));
        if (state == null) {
            throw new IllegalArgumentException("name must be that of a body (got: \"" + name + "\")");
        }
        state.object = world.getObject(name);
        return state;
    }

    /** Moves everything by a time in seconds. */
    public StepResult step(double seconds) {
        Quantity.positive("seconds", seconds);
        List<BodyState> all = begin(seconds);
        Geometry still = world.snapshot().toGeometry();
        bodies.keySet().forEach(still::removeObject);
        List<BodyContact> contacts = new ArrayList<>();
        Set<String> stopped = new LinkedHashSet<>();
        double left = seconds;
        int most = EVENTS + EVENTS_EACH * all.size();
        List<Impact> impacts = new ArrayList<>();
        for (int event = 0; left > 0; event++) {
            List<Impact> met = new ArrayList<>();
            double share = first(all, still, left, met);
            advance(all, share * left, stopped);
            impacts.removeIf(earlier -> !earlier.lasts(NEAR));
            met.forEach(Impact::arrive);
            impacts.addAll(met);
            left = share == 1 ? 0 : left - share * left;
            resolve(impacts, contacts);
            if (event == most && left > 0) {
                all.stream().filter(each -> each.energy() > 0).forEach(each -> {
                    each.stop();
                    stopped.add(each.name);
                });
                left = 0;
            }
        }
        all.forEach(each -> turn(each, seconds, contacts));
        return new StepResult(contacts, new ArrayList<>(stopped));
    }

    private List<BodyState> begin(double seconds) {
        bodies.keySet().removeIf(name -> !world.hasObject(name));
        List<BodyState> all = new ArrayList<>(bodies.values());
        Drive rolling = new ForceDrive(0, 0, 0);
        for (BodyState each : all) {
            each.object = world.getObject(each.name);
            Drive drive = each.drive == null ? rolling : each.drive;
            if (each.drive != null || each.energy() > 0) {
                Twist next = drive.next(each.velocity(), each.body, seconds);
                boolean isSame = each.drive == null
                        && each.body.damping() == 0
                        && each.body.turnDamping() == 0
                        && each.body.maxSpeed() == Double.POSITIVE_INFINITY
                        && each.body.maxTurn() == Double.POSITIVE_INFINITY;
                if (!isSame) { // which saves what rounding to its own axes and back would change
                    each.setVelocity(next);
                }
            }
        }
        return all;
    }

    /** The share of the time left until something meets, and what meets then. */
    private double first(List<BodyState> all, Geometry still, double left, List<Impact> impacts) {
        List<Impact> met = new ArrayList<>();
        List<Double> shares = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            BodyState a = all.get(i);
            if (a.vx != 0 || a.vz != 0) {
                still.addObjectUnchecked(a.object);
                meet(still, a, null, a.vx * left, a.vz * left, left, met, shares);
                still.removeObject(a.name);
            }
            for (int j = i + 1; j < all.size(); j++) {
                BodyState b = all.get(j);
                double dx = (a.vx - b.vx) * left;
                double dz = (a.vz - b.vz) * left;
                if ((dx != 0 || dz != 0) && a.mayMeet(b, dx, dz, GAP)) {
                    pair.addObjectUnchecked(b.object);
                    pair.addObjectUnchecked(a.object);
                    meet(pair, a, b, dx, dz, left, met, shares);
                    pair.removeObject(a.name);
                    pair.removeObject(b.name);
                }
            }
        }
        double least = 1;
        for (double share : shares) {
            least = Math.min(least, share);
        }
        for (int k = 0; k < met.size(); k++) {
            if (shares.get(k) <= least + TOGETHER) {
                impacts.add(met.get(k));
            }
        }
        return met.isEmpty() ? 1 : least;
    }

    private void meet(
            Geometry in,
            BodyState a,
            @Nullable BodyState b,
            double dx,
            double dz,
            double left,
            List<Impact> met,
            List<Double> shares) {
        MoveResult result = in.moveToContact(a.name, along(a.object, dx, dz), GAP);
        Point point = result.contact();
        Point normal = result.normal();
        if (result.allowed() || point == null || normal == null) {
            return;
        }
        GeometryObject obstacle = result.obstacle();
        Surface other = b == null ? ground : b.body.surface();
        double behind = b == null ? 0 : result.fraction() * left;
        Point there = b == null ? point : new Point(point.x() + b.vx * behind, point.y(), point.z() + b.vz * behind);
        met.add(new Impact(
                a,
                b,
                obstacle == null ? null : obstacle.name(),
                a.body.surface().against(other),
                there,
                normal));
        shares.add(result.fraction());
    }

    /** A displacement in the world's axes as a move along an object's own. */
    private static Move along(GeometryObject object, double dx, double dz) {
        double[] r = object.rotation();
        return new Move(r[0] * dx + r[6] * dz, r[1] * dx + r[7] * dz, r[2] * dx + r[8] * dz, 0, 0);
    }

    /** Moves all bodies at once: those that are in each other's way wait for each other; whoever cannot go stays and stops. */
    private void advance(List<BodyState> all, double time, Set<String> stopped) {
        List<BodyState> waiting = new ArrayList<>(all);
        waiting.removeIf(each -> each.vx * time == 0 && each.vz * time == 0);
        boolean isMoving = true;
        while (isMoving) {
            isMoving = waiting.removeIf(each -> goes(each, time));
        }
        for (BodyState each : waiting) {
            each.stop();
            stopped.add(each.name);
        }
    }

    private boolean goes(BodyState each, double time) {
        boolean gone = world.moveGlobal(each.name, new Move(each.vx * time, 0, each.vz * time, 0, 0))
                .allowed();
        Point from = each.object.center();
        Point to = new Point(from.x() + each.vx * time, from.y(), from.z() + each.vz * time);
        // What is on the way now may be gone when the body comes by: that way was swept with all in motion.
        gone = gone || (each.object.pose().isUpright() && world.placeObject(each.name, to, each.object.heading()));
        if (gone) {
            each.object = world.getObject(each.name);
        }
        return gone;
    }

    private static void resolve(List<Impact> impacts, List<BodyContact> contacts) {
        Set<Impact> hit = new LinkedHashSet<>();
        boolean isAny = true;
        for (int round = 0; round < ROUNDS && isAny; round++) {
            isAny = false;
            for (Impact impact : impacts) {
                if (impact.resolve()) {
                    hit.add(impact);
                    isAny = true;
                }
            }
        }
        hit.forEach(impact -> contacts.add(impact.contact()));
    }

    private void turn(BodyState each, double seconds, List<BodyContact> contacts) {
        if (each.w == 0) {
            return;
        }
        Move turn = new Move(0, 0, 0, 0, Degrees.toDegrees(each.w * seconds));
        MoveResult result = world.moveToContact(each.name, turn, GAP);
        each.object = world.getObject(each.name);
        Point point = result.contact();
        Point normal = result.normal();
        if (!result.allowed() && point != null && normal != null) {
            each.w = 0;
            GeometryObject obstacle = result.obstacle();
            contacts.add(new BodyContact(each.name, obstacle == null ? null : obstacle.name(), point, normal, 0));
        }
    }
}

package robosim.geometry.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import robosim.geometry.dynamics.spatial.Driver;
import robosim.geometry.dynamics.spatial.SpatialStepper;
import robosim.geometry.engine.World;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Pose;
import robosim.geometry.model.Twist;

/** What {@link Dynamics} does in a SPATIAL world: its bodies, as {@link SpatialStepper} has them. */
final class SpatialBodies {
    private final World world;
    private final SpatialStepper space;
    private final SurfaceTable table;
    private final List<BodyState> order = new ArrayList<>();
    private final double[] velocity = new double[4];
    private Runnable betweenParts = () -> {};
    private long changes = -1;

    // What was before a step that may be taken back, and whether it has begun.
    private long keptChanges;
    private List<BodyState> keptOrder = List.of();
    private boolean hasBegun;

    SpatialBodies(World world, SurfaceTable table, Point gravity) {
        this.world = world;
        this.table = table;
        if (!world.isExact()) {
            throw new IllegalArgumentException(
                    "world must have the accuracy EXACT where heights count (got: " + world.accuracy() + ")");
        }
        double[] pull = {gravity.x(), gravity.y(), gravity.z()};
        space = new SpatialStepper(world, pull);
        space.driveBy(this::next);
    }

    /** Refuses what cannot fall. */
    static void check(GeometryObject object) {
        if (!object.kind().isSized()) {
            throw new IllegalArgumentException(
                    "name must be that of a sphere, box, cylinder or capsule where heights count (got: \""
                            + object.name() + "\")");
        }
    }

    void pausing(Runnable between) {
        betweenParts = between;
        space.pausing(between);
    }

    /** Keeps what a step changes that is about to begin. */
    void keep() {
        space.keep();
        keptChanges = changes;
        keptOrder = List.copyOf(order);
        hasBegun = false;
    }

    /** Takes a step back that was not made; the bodies are given as they were. */
    void undo(Map<String, BodyState> bodies) {
        space.undo(hasBegun);
        changes = keptChanges;
        order.clear();
        keptOrder.forEach(each -> order.add(bodies.getOrDefault(each.name, each)));
        Dynamics.ignore(space.passing(), order, world.objects);
    }

    /** Makes a step in which there is nobody. */
    void pass() {
        hasBegun = true;
        space.begin();
    }

    void advance(Map<String, BodyState> bodies, boolean isStale, double seconds) {
        if (isStale || changes != world.objects.changes()) {
            build(bodies);
        }
        for (int b = 0; b < order.size(); b++) {
            space.setVelocity(b, order.get(b).spatial);
            space.push(b, order.get(b).push());
            order.get(b).steer(seconds);
        }
        hasBegun = true;
        space.begin();
        space.run(seconds, table);
        for (int b = 0; b < order.size(); b++) {
            space.velocity(b, order.get(b).spatial);
        }
    }

    private void build(Map<String, BodyState> bodies) {
        ObjectTable objects = world.objects;
        changes = objects.changes();
        bodies.values().removeIf(each -> !each.isThere(world));
        space.clear();
        order.clear();
        Dynamics.ignore(space.passing(), bodies.values(), objects);
        table.begin(objects);
        for (BodyState each : bodies.values()) {
            int id = world.mover(each.name);
            GeometryObject object = objects.value(id);
            Body body = each.body;
            table.put(id, body.surface());
            order.add(each);
            int b = space.add(
                    id,
                    body.mass(),
                    body.moments(object),
                    object.kind() == GeometryObject.Kind.SPHERE,
                    Inertia.reach(object));
            double turn = body.maxTurn();
            space.limit(
                    b,
                    body.floorFriction(),
                    body.damping(),
                    body.turnDamping(),
                    body.maxSpeed(),
                    turn < Double.POSITIVE_INFINITY ? Degrees.toRadians(turn) : turn);
            space.resist(b, body.drag(), body.rolling());
        }
    }

    /** What the drive of a body makes of its velocity in a time. */
    private boolean next(int b, Driver.Aim aim, double seconds) {
        BodyState state = order.get(b);
        Drive drive = state.drive;
        if (drive == null) {
            return false;
        }
        if (drive instanceof SwerveDrive) {
            betweenParts.run(); // its wheels may take a while
        }
        velocity[0] = aim.forward;
        velocity[1] = 0;
        velocity[2] = aim.right;
        velocity[3] = Degrees.toDegrees(aim.turn);
        drive(drive, velocity, state.body, seconds);
        aim.forward = velocity[0];
        aim.right = velocity[2];
        aim.turn = Degrees.toRadians(velocity[3]);
        aim.acceleration = acceleration(drive, state.body);
        aim.turnAcceleration = turnAcceleration(drive);
        aim.rim = rim(drive);
        aim.isAnyWay = isAnyWay(drive);
        aim.isForce = drive instanceof ForceDrive;
        return true;
    }

    // ---- drives on plain numbers, which allocate nothing: m/s forward, up and to the right, degrees a second ----

    /** What {@link Drive#next} answers, in place. */
    private static void drive(Drive drive, double[] v, Body body, double seconds) {
        if (drive instanceof DifferentialDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof OmnidirectionalDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof AckermannDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof SwerveDrive of) {
            of.next(v, body, seconds);
        } else if (drive instanceof VelocityDrive of) {
            of.next(v, body);
        } else if (drive instanceof ForceDrive of) {
            of.next(v, body, seconds);
        }
    }

    /** The most acceleration along the ground, m/s^2; infinite for no limit. */
    private static double acceleration(Drive drive, Body body) {
        if (drive instanceof SwerveDrive of) {
            return of.acceleration(body);
        }
        if (drive instanceof DifferentialDrive of) {
            return of.maxAcceleration();
        }
        if (drive instanceof OmnidirectionalDrive of) {
            return of.maxAcceleration();
        }
        return drive instanceof AckermannDrive of ? of.maxAcceleration() : Double.POSITIVE_INFINITY;
    }

    /** Metres from the middle to each of two wheels; 0 for other drives. */
    private static double rim(Drive drive) {
        return drive instanceof DifferentialDrive of ? of.track() / 2 : 0;
    }

    /** The most angular acceleration, radians/s^2; infinite for no limit. */
    private static double turnAcceleration(Drive drive) {
        if (drive instanceof OmnidirectionalDrive of && of.maxTurnAcceleration() < Double.POSITIVE_INFINITY) {
            return Degrees.toRadians(of.maxTurnAcceleration());
        }
        return Double.POSITIVE_INFINITY;
    }

    /** Whether it may go sideways. */
    private static boolean isAnyWay(Drive drive) {
        return drive instanceof OmnidirectionalDrive
                || drive instanceof SwerveDrive
                || drive instanceof VelocityDrive
                || drive instanceof ForceDrive;
    }

    static SpatialVelocity velocity(BodyState of) {
        double[] v = of.spatial;
        return new SpatialVelocity(
                v[0], v[1], v[2], Degrees.toDegrees(v[3]), Degrees.toDegrees(v[4]), Degrees.toDegrees(v[5]));
    }

    static void setVelocity(BodyState of, SpatialVelocity to) {
        double[] v = of.spatial;
        v[0] = to.x();
        v[1] = to.y();
        v[2] = to.z();
        v[3] = Degrees.toRadians(to.rx());
        v[4] = Degrees.toRadians(to.ry());
        v[5] = Degrees.toRadians(to.rz());
    }

    /** Gives a body an impulse and an angular impulse about its centre, six numbers in the world's axes. */
    static void give(BodyState to, GeometryObject object, double[] by) {
        Pose pose = object.pose();
        double[] moments = to.body.moments(object);
        for (int axis = 0; axis < 3; axis++) {
            to.spatial[axis] += by[axis] / to.body.mass();
            double turn =
                    pose.rotation(axis) * by[3] + pose.rotation(3 + axis) * by[4] + pose.rotation(6 + axis) * by[5];
            for (int row = 0; row < 3; row++) {
                to.spatial[3 + row] += pose.rotation(3 * row + axis) * turn / moments[axis];
            }
        }
    }

    /** The velocity along the own axes, and about the own Y. */
    static Twist twist(BodyState of, Pose pose) {
        double[] v = of.spatial;
        double[] own = new double[4];
        for (int k = 0; k < 4; k++) {
            int column = k == 3 ? 1 : k;
            int from = k == 3 ? 3 : 0;
            own[k] = pose.rotation(column) * v[from]
                    + pose.rotation(3 + column) * v[from + 1]
                    + pose.rotation(6 + column) * v[from + 2];
        }
        return new Twist(own[0], own[1], own[2], Degrees.toDegrees(own[3]));
    }

    static void setTwist(BodyState of, Pose pose, Twist to) {
        double turn = Degrees.toRadians(to.ry());
        for (int row = 0; row < 3; row++) {
            int r = 3 * row;
            of.spatial[row] = pose.rotation(r) * to.x() + pose.rotation(r + 1) * to.y() + pose.rotation(r + 2) * to.z();
            of.spatial[3 + row] = pose.rotation(r + 1) * turn;
        }
    }

    StepResult last() {
        return StepResult.of(space.touched(), space.before(), betweenParts);
    }
}

package robosim.geometry.world.check;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;

/** Where one robot gets to on a grid of straight moves and turns by 45 degrees, among static objects alone. */
final class GridReachability {
    private static final int TURNS = 8;
    private static final double TURN = 360.0 / TURNS;

    /** Most places and headings of a grid: some seconds among boxes and cylinders, most of a minute among large meshes. */
    private static final double MOST = 60_000;

    /** Most places and headings that are looked at near the start, where all of a world would need too coarse a step. */
    static final int NEAR = 20_000;

    /** Most places and headings of the whole grid of such a search; it has a bit for each. */
    private static final double MOST_NEAR = 1 << 28;

    /** So many of the places that it got to are kept for other questions. */
    private static final int KEPT = 500;

    /** A robot without an extent goes in steps of this share of the world. */
    private static final double POINT_STEP = 1.0 / 256;

    private final World world;
    private final Geometry geometry;
    private final GeometryObject body;
    private final String name;
    private final Enclosure enclosure;
    private final boolean upright;
    private final int turns;
    private final double wanted;
    private final double step;

    /** Places and headings after which it gives up. */
    private final int limit;

    /** Places along X and Z, and how many of them come before the robot's own. */
    private final int countX;

    private final int countZ;
    private final int beforeX;
    private final int beforeZ;

    private BitSet seen = new BitSet();
    private int[] queue = new int[1024];
    private int queued;
    private double heading;
    private int places;
    private int leastX;
    private int leastZ;
    private int mostX;
    private int mostZ;
    private boolean isWhole = true;

    /**
     * A trip through all of the world, at a step that can be afforded.
     *
     * @param halvings of the first step
     */
    static GridReachability far(World world, Geometry geometry, GeometryObject robot, int halvings) {
        double wanted = wanted(world, robot);
        int turns = turns(robot);
        double affordable = Math.max(
                Math.sqrt(world.width() / MOST) * Math.sqrt(world.length()) * Math.sqrt(turns),
                Math.max(world.width(), world.length()) / MOST * turns);
        double step = Math.max(StrictMath.scalb(wanted, -halvings), affordable);
        return new GridReachability(world, geometry, robot, step, Integer.MAX_VALUE);
    }

    /** A trip at the step that is wanted, which ends where it has seen {@link #NEAR}; null in a world too large for it. */
    static @Nullable GridReachability near(World world, Geometry geometry, GeometryObject robot) {
        double step = wanted(world, robot);
        double states = (world.width() / step + 1) * (world.length() / step + 1) * turns(robot);
        return states <= MOST_NEAR ? new GridReachability(world, geometry, robot, step, NEAR) : null;
    }

    private GridReachability(World world, Geometry geometry, GeometryObject robot, double step, int limit) {
        this.world = world;
        this.geometry = geometry;
        this.body = robot;
        this.name = String.valueOf(robot.name());
        this.enclosure = Enclosure.of(robot);
        this.upright = robot.pose().isUpright();
        this.turns = turns(robot);
        this.wanted = wanted(world, robot);
        this.step = step;
        this.limit = limit;
        Point c = robot.center();
        beforeX = steps(c.x() + world.width() / 2);
        beforeZ = steps(c.z() + world.length() / 2);
        countX = beforeX + steps(world.width() / 2 - c.x()) + 1;
        countZ = beforeZ + steps(world.length() / 2 - c.z()) + 1;
    }

    private static int turns(GeometryObject robot) {
        boolean upright = robot.pose().isUpright();
        boolean round = robot instanceof SphereObject || (robot instanceof CylinderObject && upright);
        return round || !upright ? 1 : TURNS;
    }

    private static double wanted(World world, GeometryObject robot) {
        double narrow = Enclosure.of(robot).narrow();
        return narrow > 0 ? narrow / 2 : Math.min(world.width(), world.length()) * POINT_STEP;
    }

    private int steps(double way) {
        return (int) Math.max(0, Math.floor(way / step));
    }

    double step() {
        return step;
    }

    int places() {
        return places;
    }

    /** Whether it was made in steps as fine as wanted; none is for what has no extent, so for that any is. */
    boolean isFine() {
        return step <= wanted || enclosure.narrow() == 0;
    }

    /** Whether it got everywhere that its steps lead to, and did not give up before. */
    boolean isWhole() {
        return isWhole;
    }

    /** How many places with their headings are kept of it, for {@link #reached}. */
    int kept() {
        return queued;
    }

    /** A robot at one of the places that were kept, turned from how it stands as the traveller was. */
    GeometryObject reached(int k, GeometryObject robot) {
        int place = queue[k] / turns;
        GeometryObject there =
                robot.movedTo(new Point(x(place / countZ), robot.center().y(), z(place % countZ)));
        double turn = heading - body.heading() + TURN * (queue[k] % turns);
        return turns > 1 && turn != 0 && robot.pose().isUpright() ? there.turned(0, turn) : there;
    }

    double area() {
        return places * step * step;
    }

    Room room(List<String> names) {
        double half = enclosure.narrow() / 2;
        return new Room(
                names,
                x(leastX) - half,
                z(leastZ) - half,
                x(mostX) + half,
                z(mostZ) + half,
                area(),
                places,
                step,
                isFine() && isWhole);
    }

    private double x(int i) {
        return body.center().x() + (i - beforeX) * step;
    }

    private double z(int i) {
        return body.center().z() + (i - beforeZ) * step;
    }

    /**
     * Goes everywhere.
     *
     * @param others robots to be met
     * @param met    told the number of each that is
     */
    void go(List<GeometryObject> others, IntConsumer met, Watch watch) {
        if (!geometry.addObjectUnchecked(body)) {
            throw new IllegalStateException("it does not stand within the world: " + body);
        }
        try {
            start();
            BitSet placesSeen = new BitSet();
            BitSet missing = new BitSet();
            missing.set(0, others.size());
            int turned = 0;
            for (int at = 0; at < queued; at++) {
                if (at >= limit) {
                    isWhole = false;
                    break;
                }
                watch.at("the ways of " + name, at, Math.min(limit, (long) countX * countZ * turns));
                int state = queue[at];
                int place = state / turns;
                if (!placesSeen.get(place)) {
                    placesSeen.set(place);
                    count(place / countZ, place % countZ);
                }
                meet(state, others, missing, met);
                spread(state);
                // Turns cost most: only where no straight way leads on.
                while (turns > 1 && at == queued - 1 && turned < queued) {
                    turn(queue[turned++]);
                }
            }
        } finally {
            geometry.removeObject(name);
            keep();
        }
    }

    /** Forgets all but a few places, evenly from first to last. */
    private void keep() {
        int kept = Math.min(queued, KEPT);
        int[] some = new int[kept];
        for (int k = 0; k < kept; k++) {
            some[k] = queue[(int) ((long) k * queued / kept)];
        }
        queue = some;
        queued = kept;
        seen = new BitSet();
    }

    private void start() {
        leastX = mostX = beforeX;
        leastZ = mostZ = beforeZ;
        heading = body.heading();
        double square = Math.rint(heading / TURN) * TURN;
        // A crooked start is put straight where there is room for that.
        if (turns > 1 && square != heading && geometry.simpleTurn(name, square - heading)) {
            heading = square;
        }
        enqueue((beforeX * countZ + beforeZ) * turns);
    }

    private void count(int i, int j) {
        places++;
        leastX = Math.min(leastX, i);
        mostX = Math.max(mostX, i);
        leastZ = Math.min(leastZ, j);
        mostZ = Math.max(mostZ, j);
    }

    private void enqueue(int state) {
        seen.set(state);
        if (queued == queue.length) {
            queue = Arrays.copyOf(queue, 2 * queued);
        }
        queue[queued++] = state;
    }

    private void spread(int state) {
        int place = state / turns;
        int i = place / countZ;
        int j = place % countZ;
        attempt(state, i > 0, state - countZ * turns, -step, 0);
        attempt(state, i + 1 < countX, state + countZ * turns, step, 0);
        attempt(state, j > 0, state - turns, 0, -step);
        attempt(state, j + 1 < countZ, state + turns, 0, step);
    }

    private void turn(int state) {
        int turn = state % turns;
        attemptTurn(state, state - turn + (turn + 1) % turns, TURN);
        attemptTurn(state, state - turn + (turn + turns - 1) % turns, -TURN);
    }

    private void attempt(int from, boolean exists, int to, double dx, double dz) {
        if (exists
                && !seen.get(to)
                && put(from)
                && geometry.moveGlobal(name, new Move(dx, 0, dz, 0, 0)).allowed()) {
            enqueue(to);
        }
    }

    private void attemptTurn(int from, int to, double degrees) {
        // Whether it may stand there at all is soon told.
        if (!seen.get(to) && put(to) && put(from) && geometry.simpleTurn(name, degrees)) {
            enqueue(to);
        }
    }

    /** Puts the robot at a place of the grid with a heading; false where it may not stand there by a rounding. */
    private boolean put(int state) {
        int place = state / turns;
        Point at = new Point(x(place / countZ), body.center().y(), z(place % countZ));
        if (upright) {
            return geometry.placeObject(name, at, heading + TURN * (state % turns));
        }
        // Only what is upright can be placed.
        geometry.removeObject(name);
        boolean free = geometry.addObject(body.movedTo(at));
        if (!free) {
            geometry.addObjectUnchecked(body);
        }
        return free;
    }

    private void meet(int state, List<GeometryObject> others, BitSet missing, IntConsumer met) {
        int place = state / turns;
        double x = x(place / countZ);
        double z = z(place % countZ);
        for (int k = missing.nextSetBit(0); k >= 0; k = missing.nextSetBit(k + 1)) {
            Point other = others.get(k).center();
            double near = (enclosure.diagonal() + Enclosure.of(others.get(k)).diagonal()) / 2 + 2 * step;
            if (StrictMath.hypot(other.x() - x, other.z() - z) <= near && meets(state, others.get(k))) {
                missing.clear(k);
                met.accept(k);
            }
        }
    }

    /**
     * Whether the body, going straight from there to where the other stands, meets the other before anything else: at its
     * own height first, and then up or down where that passes the other by.
     */
    private boolean meets(int state, GeometryObject other) {
        if (!put(state) || !geometry.addObjectUnchecked(other)) {
            return false;
        }
        try {
            if (!put(state)) {
                return true; // it stands in the other
            }
            Point from = geometry.getObject(name).center();
            Point to = other.center();
            MoveResult across = geometry.moveGlobal(name, new Move(to.x() - from.x(), 0, to.z() - from.z(), 0, 0));
            if (!across.allowed() || world.dimension() == Dimension.PLANAR) {
                return across.allowed() || isBlockedBy(other, across);
            }
            MoveResult upright = geometry.moveGlobal(name, new Move(0, to.y() - from.y(), 0, 0, 0));
            return upright.allowed() || isBlockedBy(other, upright);
        } finally {
            geometry.removeObject(String.valueOf(other.name()));
        }
    }

    private static boolean isBlockedBy(GeometryObject other, MoveResult refused) {
        GeometryObject obstacle = refused.obstacle();
        return obstacle != null && Objects.equals(obstacle.name(), other.name());
    }
}

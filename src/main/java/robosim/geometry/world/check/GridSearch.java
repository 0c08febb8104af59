package robosim.geometry.world.check;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.MoveResult;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.world.World;

/** The cells of a grid that one robot reaches by straight moves and turns of 45 degrees, among static objects only. */
final class GridSearch {
    private static final int TURNS = 8;
    private static final double TURN = 360.0 / TURNS;

    /**
     * Maximum number of places and headings of a grid: a few seconds among boxes and cylinders, most of a minute among
     * large meshes.
     */
    private static final double MOST = 60_000;

    /** That of the first grid, which is enough where robots have room: some tenths of a second. */
    private static final double MOST_FIRST = 3_000;

    /**
     * Maximum number of places and headings explored near the start, where the whole world would need too coarse a
     * step.
     */
    static final int NEAR = 20_000;

    /** Maximum number of places and headings of the whole grid of such a search, each of which takes a bit. */
    private static final double MOST_NEAR = 1 << 28;

    /** How many of the places reached are kept for other queries. */
    private static final int KEPT = 500;

    /** The step of a robot without extent, as a fraction of the world. */
    private static final double POINT_STEP = 1.0 / 256;

    /** How far in steps a clearance is measured: farther costs more, and spares little. */
    private static final double STEPS = 16;

    /** After so many clearances it is seen whether they are worth their time: one in so many must spare moves. */
    private static final int TRIED = 64;

    private static final int LEAST_USE = 4;

    /** Of the size of the world. */
    private static final double ROUNDED = 1e-11;

    /** Above 2 sin(45 / 2), in degrees. */
    private static final double TURN_CHORD = 0.766;

    private final World world;
    private final Geometry geometry;
    private final GeometryObject body;
    private final String name;
    private final double narrow;
    private final double diagonal;
    private final boolean upright;
    private final int turns;
    private final double wanted;
    private final double step;

    /** Places and headings after which it gives up. */
    private final int limit;

    /** Number of places along X and Z, and how many of them precede the robot's own. */
    private final int countX;

    private final int countZ;
    private final int beforeX;
    private final int beforeZ;

    /** How far the body reaches from its centre, seen from above. */
    private final double reach;

    private final String work;
    private BitSet seen = new BitSet();
    private int[] queue = new int[1024];

    /** By entry of the queue, a distance that the body has at least from everything there; 0 if none is known. */
    private double[] clearances = new double[1024];

    private int asked;
    private int useful;
    private int queued;
    private double heading;
    private int places;
    private int leastX;
    private int leastZ;
    private int mostX;
    private int mostZ;
    private boolean isWhole = true;

    /**
     * A search of the whole world, at the finest step that is affordable.
     *
     * @param level 0 for a first look, of few places; then how often the desired step is halved, plus 1
     */
    static GridSearch far(World world, Geometry geometry, GeometryObject robot, int level) {
        double wanted = wanted(world, robot);
        int turns = turns(robot);
        double most = level == 0 ? MOST_FIRST : MOST;
        double affordable = Math.max(
                Math.sqrt(world.width() / most) * Math.sqrt(world.length()) * Math.sqrt(turns),
                Math.max(world.width(), world.length()) / most * turns);
        double step = Math.max(StrictMath.scalb(wanted, -Math.max(0, level - 1)), affordable);
        return new GridSearch(world, geometry, robot, step, Integer.MAX_VALUE);
    }

    /** A search at the desired step, which ends after {@link #NEAR} places; null in a world too large for it. */
    static @Nullable GridSearch near(World world, Geometry geometry, GeometryObject robot) {
        double step = wanted(world, robot);
        double states = (world.width() / step + 1) * (world.length() / step + 1) * turns(robot);
        return states <= MOST_NEAR ? new GridSearch(world, geometry, robot, step, NEAR) : null;
    }

    private GridSearch(World world, Geometry geometry, GeometryObject robot, double step, int limit) {
        this.world = world;
        this.geometry = geometry;
        this.body = robot;
        this.name = String.valueOf(robot.name());
        this.narrow = narrow(robot);
        this.diagonal = diagonal(robot);
        this.upright = robot.pose().isUpright();
        this.turns = turns(robot);
        this.wanted = wanted(world, robot);
        this.step = step;
        this.limit = limit;
        this.work = "the paths of " + name;
        Point c = robot.center();
        Bounds bounds = robot.bounds();
        reach = StrictMath.hypot(
                Math.max(bounds.maxX() - c.x(), c.x() - bounds.minX()),
                Math.max(bounds.maxZ() - c.z(), c.z() - bounds.minZ()));
        beforeX = steps(c.x() + world.width() / 2);
        beforeZ = steps(c.z() + world.length() / 2);
        countX = beforeX + steps(world.width() / 2 - c.x()) + 1;
        countZ = beforeZ + steps(world.length() / 2 - c.z()) + 1;
    }

    private static int turns(GeometryObject robot) {
        boolean upright = robot.pose().isUpright();
        boolean round = switch (robot.kind()) {
            case SPHERE -> true;
            case CYLINDER, CAPSULE -> upright;
            case BOX, MESH, GROUP, GRID -> false;
        };
        return round || !upright ? 1 : TURNS;
    }

    private static double wanted(World world, GeometryObject robot) {
        double narrow = narrow(robot);
        return narrow > 0 ? narrow / 2 : Math.min(world.width(), world.length()) * POINT_STEP;
    }

    /** The smaller one of an object's extents along X and Z. */
    static double narrow(GeometryObject object) {
        Bounds bounds = object.bounds();
        return Math.min(bounds.width(), bounds.length());
    }

    /** The diagonal of an object's bounds, seen from above. */
    static double diagonal(GeometryObject object) {
        Bounds bounds = object.bounds();
        return StrictMath.hypot(bounds.width(), bounds.length());
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

    /** Whether its step is as fine as desired; for a robot without extent, any step is. */
    boolean isFine() {
        return step <= wanted || narrow == 0;
    }

    /** Whether it explored everything that is reachable, rather than giving up. */
    boolean isWhole() {
        return isWhole;
    }

    /** The number of places with headings that are kept, for {@link #reached}. */
    int kept() {
        return queued;
    }

    /** A robot at one of the kept places, turned relative to its own heading as the searching robot was. */
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
        double half = narrow / 2;
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
     * Runs the search.
     *
     * @param others robots that may be reached
     * @param isOver whether it is over when all of them are reached
     * @param met    called with the index of each robot that is reached
     */
    void run(List<GeometryObject> others, boolean isOver, IntConsumer met, Watch watch) {
        if (!geometry.addObjectUnchecked(body)) {
            throw new IllegalStateException("the robot is not within the world: " + body);
        }
        try {
            start();
            BitSet placesSeen = new BitSet();
            BitSet missing = new BitSet();
            missing.set(0, others.size());
            double[] diagonals =
                    others.stream().mapToDouble(GridSearch::diagonal).toArray();
            int turned = 0;
            for (int at = 0; at < queued; at++) {
                if (at >= limit) {
                    isWhole = false;
                    break;
                }
                watch.at(work, at, Math.min(limit, (long) countX * countZ * turns));
                int state = queue[at];
                int place = state / turns;
                if (!placesSeen.get(place)) {
                    placesSeen.set(place);
                    count(place / countZ, place % countZ);
                }
                meet(state, others, diagonals, missing, met);
                if (isOver && missing.isEmpty()) {
                    break;
                }
                spread(at);
                // Turns cost most, so they are tried only if no straight move leads on.
                while (turns > 1 && at == queued - 1 && turned < queued) {
                    turn(turned++);
                }
            }
        } finally {
            geometry.removeObject(name);
            keep();
        }
    }

    /** Drops all but a few places, spread evenly from first to last. */
    private void keep() {
        int kept = Math.min(queued, KEPT);
        int[] some = new int[kept];
        for (int k = 0; k < kept; k++) {
            some[k] = queue[(int) ((long) k * queued / kept)];
        }
        queue = some;
        queued = kept;
        seen = new BitSet();
        clearances = new double[0];
    }

    private void start() {
        leastX = mostX = beforeX;
        leastZ = mostZ = beforeZ;
        heading = body.heading();
        double square = Math.rint(heading / TURN) * TURN;
        // A start heading that is off the grid is aligned if there is room for that.
        if (turns > 1 && square != heading && geometry.simpleTurn(name, square - heading)) {
            heading = square;
        }
        enqueue((beforeX * countZ + beforeZ) * turns, 0);
    }

    private void count(int i, int j) {
        places++;
        leastX = Math.min(leastX, i);
        mostX = Math.max(mostX, i);
        leastZ = Math.min(leastZ, j);
        mostZ = Math.max(mostZ, j);
    }

    private void enqueue(int state, double clearance) {
        seen.set(state);
        if (queued == queue.length) {
            queue = Arrays.copyOf(queue, 2 * queued);
            clearances = Arrays.copyOf(clearances, 2 * queued);
        }
        clearances[queued] = clearance;
        queue[queued++] = state;
    }

    private void spread(int at) {
        int state = queue[at];
        int place = state / turns;
        int i = place / countZ;
        int j = place % countZ;
        boolean[] open = {
            i > 0 && !seen.get(state - countZ * turns),
            i + 1 < countX && !seen.get(state + countZ * turns),
            j > 0 && !seen.get(state - turns),
            j + 1 < countZ && !seen.get(state + turns)
        };
        if (open[0] || open[1] || open[2] || open[3]) {
            double clearance = clearance(at);
            attempt(state, open[0], clearance, state - countZ * turns, -step, 0);
            attempt(state, open[1], clearance, state + countZ * turns, step, 0);
            attempt(state, open[2], clearance, state - turns, 0, -step);
            attempt(state, open[3], clearance, state + turns, 0, step);
        }
    }

    /**
     * What the body has at least as a distance from everything there. No move that is shorter meets anything, so that most
     * places of an open floor need no question; what is near something is asked for each of its moves.
     */
    private double clearance(int at) {
        if (clearances[at] > step || (asked >= TRIED && useful * LEAST_USE < asked) || !put(queue[at])) {
            return clearances[at];
        }
        asked++;
        double most = STEPS * step;
        double measured = Math.min(most, geometry.getProximity(name, most));
        int place = queue[at] / turns;
        double border = Math.min(
                        world.width() / 2 - Math.abs(x(place / countZ)),
                        world.length() / 2 - Math.abs(z(place % countZ)))
                - reach;
        // Far above the error of either number, which is that of a few roundings.
        double slack = ROUNDED * (world.width() + world.height() + world.length());
        double clearance = Math.max(0, Math.min(measured, border) - slack);
        useful += clearance > step ? 1 : 0;
        clearances[at] = clearance;
        return clearance;
    }

    private void turn(int at) {
        int state = queue[at];
        int turn = state % turns;
        attemptTurn(at, state - turn + (turn + 1) % turns, TURN);
        attemptTurn(at, state - turn + (turn + turns - 1) % turns, -TURN);
    }

    private void attempt(int from, boolean isOpen, double clearance, int to, double dx, double dz) {
        if (!isOpen) {
            return;
        }
        if (clearance > step) {
            enqueue(to, clearance - step);
        } else if (put(from)
                && geometry.moveGlobal(name, new Move(dx, 0, dz, 0, 0)).allowed()) {
            enqueue(to, 0);
        }
    }

    private void attemptTurn(int at, int to, double degrees) {
        if (seen.get(to)) {
            return;
        }
        // A point at the distance 1 from the axis moves along an arc within twice the sine of half the turn.
        double swept = TURN_CHORD * reach;
        if (clearances[at] > swept) {
            enqueue(to, clearances[at] - swept);
            return;
        }
        int from = queue[at];
        // Checking whether it may stand there at all is fast.
        if (put(to) && put(from) && geometry.simpleTurn(name, degrees)) {
            enqueue(to, 0);
        }
    }

    /** Puts the robot at a place of the grid with a heading; returns false if rounding makes that place not free. */
    private boolean put(int state) {
        int place = state / turns;
        Point at = new Point(x(place / countZ), body.center().y(), z(place % countZ));
        if (upright) {
            return geometry.placeObject(name, at, heading + TURN * (state % turns));
        }
        // Only upright objects can be placed.
        geometry.removeObject(name);
        boolean free = geometry.addObject(body.movedTo(at));
        if (!free) {
            geometry.addObjectUnchecked(body);
        }
        return free;
    }

    private void meet(int state, List<GeometryObject> others, double[] diagonals, BitSet missing, IntConsumer met) {
        int place = state / turns;
        double x = x(place / countZ);
        double z = z(place % countZ);
        for (int k = missing.nextSetBit(0); k >= 0; k = missing.nextSetBit(k + 1)) {
            Point other = others.get(k).center();
            double near = (diagonal + diagonals[k]) / 2 + 2 * step;
            if (StrictMath.hypot(other.x() - x, other.z() - z) <= near && meets(state, others.get(k))) {
                missing.clear(k);
                met.accept(k);
            }
        }
    }

    /**
     * Whether the body, moving straight from there to the other's place, hits the other before anything else: at its
     * own height first, and then up or down if it has passed the other.
     */
    private boolean meets(int state, GeometryObject other) {
        if (!put(state) || !geometry.addObjectUnchecked(other)) {
            return false;
        }
        try {
            if (!put(state)) {
                return true; // it overlaps the other
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

package robosim.geometry.world.check;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.world.World;

/** The cells of a grid that one robot reaches by straight moves and turns of 45 degrees, among static objects only. */
final class GridSearch {
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

    /** By how much the edge of a search is expected to grow at least if its step is refined: narrow ways open. */
    private static final double GROWTH = 1.1;

    /** The largest fraction of a step that is worth another search. */
    private static final double LEAST_GAIN = 0.75;

    /** How many of the places reached are kept for other queries. */
    private static final int KEPT = 500;

    /** The step of a robot without extent, as a fraction of the world. */
    private static final double POINT_STEP = 1.0 / 256;

    private final Geometry geometry;
    private final GeometryObject body;
    private final String name;
    private final double narrow;
    private final double wanted;
    private final double step;
    private final PlaceGrid grid;
    private final RobotSteps steps;

    /** Places and headings after which it gives up. */
    private final int limit;

    private BitSet seen = new BitSet();
    private int[] queue = new int[1024];

    /** By entry of the queue, {@link RobotSteps#clearance} as far as it is known. */
    private double[] clearances = new double[1024];

    private final int[] next = new int[4];
    private int queued;
    private int places;

    /** Number of states whose neighbours were tried. */
    private int explored;

    private double minX;
    private double minZ;
    private double maxX;
    private double maxZ;
    private boolean isWhole = true;

    /**
     * A search of the whole world, at the finest step that is affordable.
     *
     * @param level 0 for a first look, of few places; then how often the desired step is halved, plus 1
     */
    static GridSearch far(World world, Geometry geometry, Geometry statics, GeometryObject robot, int level) {
        double wanted = wanted(world, robot);
        int turns = PlaceGrid.turns(robot);
        double most = level == 0 ? MOST_FIRST : MOST;
        double affordable = Math.max(
                Math.sqrt(world.width() / most) * Math.sqrt(world.length()) * Math.sqrt(turns),
                Math.max(world.width(), world.length()) / most * turns);
        double step = Math.max(StrictMath.scalb(wanted, -Math.max(0, level - 1)), affordable);
        return new GridSearch(world, geometry, statics, robot, step, Integer.MAX_VALUE);
    }

    /** A search at the desired step, which ends after {@link #NEAR} places; null in a world too large for it. */
    static @Nullable GridSearch near(World world, Geometry geometry, Geometry statics, GeometryObject robot) {
        double step = wanted(world, robot);
        double states = (world.width() / step + 1) * (world.length() / step + 1) * PlaceGrid.turns(robot);
        return states <= MOST_NEAR ? new GridSearch(world, geometry, statics, robot, step, NEAR) : null;
    }

    /**
     * A search at up to half the step of this one, and no finer than desired, which ends after as many places as a search
     * of the whole world may have; null if no step is finer by enough that so many places could cover what this one
     * reached.
     */
    @Nullable
    GridSearch finer(World world, Geometry statics) {
        double affordable = step * Math.sqrt(explored / MOST) * GROWTH;
        // The last halving goes to the desired step at once.
        double halved = step < 3 * wanted ? wanted : step / 2;
        double finer = Math.max(halved, affordable);
        double states = (world.width() / finer + 1) * (world.length() / finer + 1) * grid.turns;
        return isFine() || (finer > wanted && finer > step * LEAST_GAIN) || states > MOST_NEAR
                ? null
                : new GridSearch(world, geometry, statics, body, finer, (int) MOST);
    }

    private GridSearch(World world, Geometry geometry, Geometry statics, GeometryObject robot, double step, int limit) {
        this.geometry = geometry;
        this.body = robot;
        this.name = String.valueOf(robot.name());
        this.narrow = PlaceGrid.narrow(robot);
        this.wanted = wanted(world, robot);
        this.step = step;
        this.limit = limit;
        grid = new PlaceGrid(world, robot, step);
        steps = new RobotSteps(geometry, statics, grid, robot);
    }

    private static double wanted(World world, GeometryObject robot) {
        double narrow = PlaceGrid.narrow(robot);
        return narrow > 0 ? narrow / 2 : Math.min(world.width(), world.length()) * POINT_STEP;
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
        Point at = grid.center(queue[k]);
        GeometryObject there = robot.movedTo(new Point(at.x(), robot.center().y(), at.z()));
        double turn = grid.heading(queue[k]) - body.heading();
        return grid.turns > 1 && turn != 0 && robot.pose().isUpright() ? there.turned(0, turn) : there;
    }

    /** Whether it says more about a room: a finished search at the desired step, or else the larger one. */
    boolean isBetterThan(GridSearch other) {
        boolean settled = isFine() && isWhole;
        return settled == (other.isFine() && other.isWhole) ? area() > other.area() : settled;
    }

    double area() {
        return places * step * step;
    }

    Room room(List<String> names, AreaBound bound) {
        double half = narrow / 2;
        double most = bound.of(body);
        return new Room(
                names,
                minX - half,
                minZ - half,
                maxX + half,
                maxZ + half,
                Math.min(area(), most),
                most,
                places,
                step,
                isFine() && isWhole);
    }

    /**
     * Runs the search.
     *
     * @param others robots that may be reached
     * @param isOver whether it is over when all of them are reached
     * @param met    called with the index of each robot that is reached
     */
    void run(List<GeometryObject> others, boolean isOver, IntConsumer met, CheckProgress watch) {
        if (!geometry.addObjectUnchecked(body)) {
            throw new IllegalStateException("the robot is not within the world: " + body);
        }
        try {
            start();
            BitSet placesSeen = new BitSet();
            BitSet missing = new BitSet();
            missing.set(0, others.size());
            double[] near = others.stream()
                    .mapToDouble(other -> (PlaceGrid.diagonal(body) + PlaceGrid.diagonal(other)) / 2 + 2 * step)
                    .toArray();
            String work = "the paths of " + name;
            int turned = 0;
            for (int at = 0; at < queued; at++) {
                if (at >= limit) {
                    isWhole = false;
                    break;
                }
                watch.at(work, at, Math.min(limit, grid.size()));
                explored++;
                int state = queue[at];
                if (!placesSeen.get(grid.place(state))) {
                    placesSeen.set(grid.place(state));
                    count(grid.x(state), grid.z(state));
                }
                meet(state, others, near, missing, met);
                if (isOver && missing.isEmpty()) {
                    break;
                }
                spread(at);
                // Turns cost most, so they are tried only if no straight move leads on.
                while (grid.turns > 1 && at == queued - 1 && turned < queued) {
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
        minX = minZ = Double.POSITIVE_INFINITY;
        maxX = maxZ = Double.NEGATIVE_INFINITY;
        double square = PlaceGrid.square(body.heading());
        // A start heading that is off the grid is aligned if there is room for that.
        if (grid.turns > 1 && square != body.heading() && geometry.simpleTurn(name, square - body.heading())) {
            grid.align(square);
        }
        enqueue(grid.start(), -1);
    }

    private void count(double x, double z) {
        places++;
        minX = Math.min(minX, x);
        minZ = Math.min(minZ, z);
        maxX = Math.max(maxX, x);
        maxZ = Math.max(maxZ, z);
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
        grid.neighbours(state, next);
        boolean isOpen = false;
        for (int k = 0; k < next.length; k++) {
            if (next[k] >= 0 && seen.get(next[k])) {
                next[k] = -1;
            }
            isOpen |= next[k] >= 0;
        }
        if (!isOpen) {
            return;
        }
        double clearance = steps.clearance(state, clearances[at]);
        clearances[at] = clearance;
        if (clearance <= step) {
            steps.slide(state, next);
        }
        for (int to : next) {
            if (to >= 0) {
                enqueue(to, clearance - step);
            }
        }
    }

    private void turn(int at) {
        turn(at, true);
        turn(at, false);
    }

    private void turn(int at, boolean isCounterClockwise) {
        int from = queue[at];
        int to = grid.turned(from, isCounterClockwise);
        if (seen.get(to)) {
            return;
        }
        if (clearances[at] < 0 && steps.isFreeAround(from)) {
            clearances[at] = 0;
        }
        if (clearances[at] >= 0 || steps.turn(from, to, isCounterClockwise ? PlaceGrid.TURN : -PlaceGrid.TURN)) {
            enqueue(to, clearances[at]);
        }
    }

    private void meet(int state, List<GeometryObject> others, double[] near, BitSet missing, IntConsumer met) {
        double x = grid.x(state);
        double z = grid.z(state);
        for (int k = missing.nextSetBit(0); k >= 0; k = missing.nextSetBit(k + 1)) {
            Point other = others.get(k).center();
            if (StrictMath.hypot(other.x() - x, other.z() - z) <= near[k] && steps.meets(state, others.get(k))) {
                missing.clear(k);
                met.accept(k);
            }
        }
    }
}

package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GridObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.ObjectGroup;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Asks a world the same seeded queries at every setting, as {@link WorldCheck} defines them. */
final class SampleQueries {
    static final long SEED = 1;

    /** Number of free places from which moves and sonars are queried, over all robots. */
    private static final int PLACES = 600;

    /** Triangles of all meshes of a world above which it is one of meshes. */
    private static final int MANY = 1000;

    /** That number in a world of meshes, among which a query takes up to a thousand times as long. */
    private static final int PLACES_AMONG_MESHES = 120;

    /**
     * Free places at which all settings that are told are queried; the others, and later all, only until they have answered
     * otherwise. No fewer than a decision needs.
     */
    private static final int FIRST = SettingComparison.MIN_ANSWERS;

    private static final int FIRST_AMONG_MESHES = 15;

    /** A robot that is a mesh is slow to move, so it gets fewer queries by this factor. */
    private static final int FEWER = 20;

    /** Maximum number of places tried for each free one. */
    private static final int TRIES = 10;

    /** One place tried in this many is one that the robot's search reached, and another one near a static object. */
    private static final int OF_SEARCH = 4;

    /** How near, in diagonals of the robot. */
    private static final double NEAR = 2;

    /** The largest length of a move, in diagonals of the robot. */
    private static final double FAR = 5;

    /** Distances count as equal if they differ by at most this fraction of the world's diagonal. */
    private static final double SAME = 1e-9;

    private final World world;
    private final RobotReachability reachability;
    private final CheckProgress watch;
    private final SplittableRandom random = new SplittableRandom(SEED);
    private final List<SettingTally> tallies;
    private final SettingTally truth;
    private final double slack;
    private final long triangles;

    /** The bounds of static objects, or of all if none is static. */
    private final List<Bounds> obstacles;

    private final @Nullable SubstituteRobot standIn;

    /** The robots that are queried, or what stands in for one. */
    private final List<WorldObject> robots;

    /** Whether heights cannot affect any level move or sonar. */
    private final boolean proven;

    /** Number of queries whose true answer is a hit. */
    private int met;

    /** Number of free places so far. */
    private int freeSoFar;

    /**
     * Questions about a world.
     *
     * @param reachability after the rooms have been found
     * @param triangles    of all meshes
     * @param tallies       as {@link SettingTally#all} makes them
     */
    SampleQueries(
            World world,
            RobotReachability reachability,
            long triangles,
            List<SettingTally> tallies,
            CheckProgress watch) {
        this.triangles = triangles;
        this.world = world;
        this.reachability = reachability;
        this.watch = watch;
        this.slack = SAME * StrictMath.hypot(StrictMath.hypot(world.width(), world.length()), world.height());
        this.tallies = tallies;
        truth = exact(world.dimension());
        standIn = world.objects().stream().anyMatch(object -> object.object().isMoveable())
                ? null
                : SubstituteRobot.of(world, truth.geometry);
        obstacles = world.objects().stream()
                .map(WorldObject::object)
                .filter(object -> !object.isMoveable())
                .map(GeometryObject::bounds)
                .toList();
        robots = standIn == null ? asked(world) : List.of(new WorldObject(standIn.body()));
        proven = !robots.isEmpty() && isProven(world, robots);
    }

    /** The settings whose answers are still compared with the true ones. */
    private List<SettingTally> open() {
        boolean first = freeSoFar <= (triangles > MANY ? FIRST_AMONG_MESHES : FIRST);
        List<SettingTally> open = new ArrayList<>(tallies.size());
        for (SettingTally tally : tallies) {
            if (tally != truth && (!tally.hasFailed() || (first && isTold(tally)))) {
                open.add(tally);
            }
        }
        return open;
    }

    /**
     * Whether users are told how often a setting that fails does so: one of the dimension that is recommended, as far as is
     * known yet, or EXACT in the other.
     */
    private boolean isTold(SettingTally tally) {
        return tally.accuracy == Accuracy.EXACT
                || tally.dimension == world.dimension()
                || (world.dimension() == Dimension.SPATIAL
                        && !exact(tally.dimension).hasFailed());
    }

    private SettingTally exact(Dimension dimension) {
        return tallies.stream()
                .filter(tally -> tally.dimension == dimension && tally.accuracy == Accuracy.EXACT)
                .findFirst()
                .orElseThrow();
    }

    /**
     * Whether further queries cannot change what is recommended: enough were made, and each setting that could still be
     * recommended has failed, as has the one that says whether heights matter. What has failed once is never
     * recommended, so the result is that of all queries.
     */
    private boolean isDecided() {
        if (!truth.setting().isAskedEnough() || met < SettingComparison.MIN_ANSWERS || freeSoFar < FIRST) {
            return false;
        }
        for (SettingTally tally : tallies) {
            boolean matters = world.dimension() == Dimension.SPATIAL
                    || tally.dimension == Dimension.PLANAR
                    || (tally.accuracy == Accuracy.EXACT && !proven);
            if (matters && tally != truth && !tally.hasFailed()) {
                return false;
            }
        }
        return true;
    }

    /**
     * The robots whose queries are made, those of the fewest parts first, which take the least time: often they decide. A
     * mesh takes seconds for a single move among other meshes, so it is left out where there is any other robot.
     */
    static List<WorldObject> asked(World world) {
        List<WorldObject> robots = world.objects().stream()
                .filter(object -> object.object().isMoveable())
                .toList();
        List<WorldObject> quick = robots.stream()
                .filter(robot -> !RobotReachability.isMany(robot.object()))
                .toList();
        return (quick.isEmpty() ? robots : quick)
                .stream()
                        .sorted(Comparator.comparingInt(robot -> parts(robot.object())))
                        .toList();
    }

    private static int parts(GeometryObject object) {
        return object instanceof ObjectGroup group
                ? group.members().stream().mapToInt(SampleQueries::parts).sum()
                : 1;
    }

    RecommendedSetting ask() {
        int places = triangles > MANY ? PLACES_AMONG_MESHES : PLACES;
        int each = Math.max(1, places / Math.max(1, robots.size()));
        int few = Math.max(1, each / FEWER);
        // If there are many robots, not all are used.
        int asked = Math.min(robots.size(), places);
        for (int k = 0; k < asked && !isDecided(); k++) {
            ask(robots.get(k), RobotReachability.isMany(robots.get(k).object()) ? few : each, k, asked);
        }
        SettingTally enough = tallies.stream()
                .filter(tally -> world.dimension() == Dimension.SPATIAL || tally.dimension == Dimension.PLANAR)
                .filter(tally -> tally.setting().isSame())
                .findFirst()
                .orElse(truth);
        boolean told = truth.setting().isAskedEnough() && met >= SettingComparison.MIN_ANSWERS;
        return new RecommendedSetting(
                told ? enough.dimension : world.dimension(),
                told ? enough.accuracy : world.accuracy(),
                proven,
                met,
                SEED,
                tallies.stream().map(SettingTally::setting).toList(),
                standIn);
    }

    private void ask(WorldObject robot, int count, int number, int robots) {
        GeometryObject home = robot.object();
        String name = String.valueOf(home.name());
        GridSearch search = standIn == null ? reachability.search(name) : null;
        tallies.forEach(tally -> tally.geometry.removeObject(name));
        int free = 0;
        for (int tries = 0; free < count && tries < count * TRIES && !isDecided(); tries++) {
            watch.at("questions", (long) number * count + free, (long) robots * count);
            GeometryObject body = tries == 0
                    ? home
                    : tries % OF_SEARCH == 0 && search != null && search.kept() > 0
                            ? search.reached(random.nextInt(search.kept()), home)
                            : tries % OF_SEARCH == 2 || standIn != null ? nearSomething(home) : anywhere(home);
            if (mayStand(body)) {
                free++;
                freeSoFar++;
                move(body, name);
                listen(robot, body, name);
            }
        }
        if (standIn == null) {
            tallies.forEach(tally -> tally.geometry.addObjectUnchecked(home));
        }
    }

    /** A place within some diagonals of the robot around a static object. */
    private GeometryObject nearSomething(GeometryObject home) {
        if (obstacles.isEmpty()) {
            return anywhere(home);
        }
        Bounds near = obstacles.get(random.nextInt(obstacles.size()));
        double more = NEAR * PlaceGrid.diagonal(home);
        return placed(
                home,
                within(near.minX() - more, near.maxX() + more, world.width()),
                within(near.minZ() - more, near.maxZ() + more, world.length()));
    }

    private double within(double least, double most, double extent) {
        double from = Math.max(least, -extent / 2);
        return from + random.nextDouble() * Math.max(0, Math.min(most, extent / 2) - from);
    }

    private GeometryObject anywhere(GeometryObject home) {
        return placed(home, (random.nextDouble() - 0.5) * world.width(), (random.nextDouble() - 0.5) * world.length());
    }

    private GeometryObject placed(GeometryObject home, double x, double z) {
        GeometryObject body = home.movedTo(new Point(x, home.center().y(), z));
        double turn = random.nextDouble(-180, 180);
        return home.pose().isUpright() ? body.turned(0, turn) : body;
    }

    /**
     * Queries all settings; returns true if the true answer is yes, and the body has then been added to every world.
     */
    private boolean mayStand(GeometryObject body) {
        if (!truth.geometry.addObjectUnchecked(body)) {
            return false; // half outside
        }
        String name = String.valueOf(body.name());
        truth.geometry.removeObject(name);
        boolean right = !truth.geometry.testObject(body);
        met += right ? 0 : 1;
        truth.places++;
        for (SettingTally tally : open()) {
            tally.places++;
            tally.placesOtherwise += tally.geometry.testObject(body) == right ? 1 : 0;
        }
        return right;
    }

    private void move(GeometryObject body, String name) {
        double way = random.nextDouble() * FAR * PlaceGrid.diagonal(body);
        Move move =
                random.nextBoolean() ? new Move(way, 0, 0, 0, 0) : new Move(0, 0, 0, 0, random.nextDouble(-180, 180));
        boolean right = moves(truth, body, name, move);
        met += right ? 0 : 1;
        truth.moves++;
        for (SettingTally tally : open()) {
            tally.moves++;
            tally.movesOtherwise += moves(tally, body, name, move) == right ? 0 : 1;
        }
    }

    /**
     * Adds the body, even in contact, tries the move and removes the body again. Only the verdict is asked for: a full result
     * of a refused move compares all that is touched, and thousands of objects may lie in one place.
     */
    private static boolean moves(SettingTally tally, GeometryObject body, String name, Move move) {
        boolean stands = tally.geometry.addObjectUnchecked(body);
        boolean allowed = stands && allows(tally.geometry, body, name, move);
        tally.geometry.removeObject(name);
        return allowed;
    }

    private static boolean allows(Geometry geometry, GeometryObject body, String name, Move move) {
        if (move.ry() == 0) {
            return geometry.simpleMove(name, move.x(), move.y(), move.z());
        }
        // The turn of a move is about the body's own Y, that of simpleTurn about the vertical.
        return body.pose().isUpright()
                ? geometry.simpleTurn(name, move.ry())
                : geometry.move(name, move).allowed();
    }

    private void listen(WorldObject robot, GeometryObject body, String name) {
        SonarRing ring = ring(robot);
        Ray mount = ring.mount(random.nextInt(ring.count()));
        double right = hears(truth, body, name, mount, ring);
        met += Double.isFinite(right) ? 1 : 0;
        truth.distances++;
        for (SettingTally tally : open()) {
            double heard = hears(tally, body, name, mount, ring);
            tally.distances++;
            if (Double.compare(heard, right) != 0 && !(Math.abs(heard - right) <= slack)) {
                tally.distancesOtherwise++;
                tally.shortest = Math.max(tally.shortest, heard < right ? right - heard : 0);
            }
        }
    }

    private SonarRing ring(WorldObject robot) {
        List<SonarRing> rings = robot.sonars();
        return rings.isEmpty()
                ? new SonarRing(360, 0, Double.POSITIVE_INFINITY, 0)
                : rings.get(random.nextInt(rings.size()));
    }

    private static double hears(SettingTally tally, GeometryObject body, String name, Ray mount, SonarRing ring) {
        if (!tally.geometry.addObjectUnchecked(body)) {
            return Double.NaN;
        }
        try {
            return tally.geometry.getSonarDistance(name, mount, ring.min(), ring.max(), ring.width());
        } catch (IllegalArgumentException vertical) {
            return Double.NaN; // a sonar of a robot lying on its side; in PLANAR it cannot point up
        } finally {
            tally.geometry.removeObject(name);
        }
    }

    /** Whether heights cannot affect any level move or sonar. */
    private static boolean isProven(World world, List<WorldObject> robots) {
        List<Bounds> bounds = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            if (!isPrism(object.object())) {
                return false;
            }
            bounds.add(object.object().bounds());
        }
        for (WorldObject robot : robots) {
            double height = robot.object().center().y();
            for (Bounds e : bounds) {
                // Bounds are rounded outwards; the object itself extends at least to this inset.
                double inset = Math.ulp(Math.max(Math.abs(e.minY()), Math.abs(e.maxY()))) * 8;
                if (!(e.minY() + inset <= height && height <= e.maxY() - inset)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean isPrism(GeometryObject object) {
        return object.pose().isUpright()
                && (object instanceof GridObject
                        || (object.kind().isSized() && object.roundedBox().ball() == 0));
    }
}

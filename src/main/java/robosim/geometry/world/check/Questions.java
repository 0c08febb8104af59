package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Move;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.SonarRing;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/** Asks a world the same seeded queries at every setting, as {@link WorldCheck} defines them. */
final class Questions {
    private static final long SEED = 1;

    /** Number of free places from which moves and sonars are queried, over all robots. */
    private static final int PLACES = 2000;

    /** A robot that is a mesh is slow to move, so it gets fewer queries by this factor. */
    private static final int FEWER = 20;

    /** Maximum number of places tried for each free one. */
    private static final int TRIES = 10;

    /** One place tried in this many is one that the robot's search reached. */
    private static final int OF_SEARCH = 4;

    /** The largest length of a move, in diagonals of the robot. */
    private static final double FAR = 5;

    /** Distances count as equal if they differ by at most this fraction of the world's diagonal. */
    private static final double SAME = 1e-9;

    private final World world;
    private final RobotReachability reachability;
    private final Watch watch;
    private final SplittableRandom random = new SplittableRandom(SEED);
    private final List<Sheet> sheets = new ArrayList<>();
    private final Sheet truth;
    private final double slack;

    /** Number of queries whose true answer is a hit. */
    private int met;

    /** One setting, with its answers. */
    private static final class Sheet {
        final Dimension dimension;
        final Accuracy accuracy;
        final Geometry geometry;
        int places;
        int placesOtherwise;
        int moves;
        int movesOtherwise;
        int distances;
        int distancesOtherwise;
        double shortest;

        Sheet(World world, Dimension dimension, Accuracy accuracy) {
            this.dimension = dimension;
            this.accuracy = accuracy;
            geometry = new Geometry(world.width(), world.height(), world.length(), dimension, accuracy);
            world.objects().forEach(object -> geometry.addObjectUnchecked(object.object()));
        }

        Setting setting() {
            return new Setting(
                    dimension,
                    accuracy,
                    places,
                    placesOtherwise,
                    moves,
                    movesOtherwise,
                    distances,
                    distancesOtherwise,
                    shortest);
        }
    }

    /** @param reachability after the rooms have been found */
    Questions(World world, RobotReachability reachability, Watch watch) {
        this.world = world;
        this.reachability = reachability;
        this.watch = watch;
        this.slack = SAME * StrictMath.hypot(StrictMath.hypot(world.width(), world.length()), world.height());
        for (Dimension dimension : Dimension.values()) {
            for (Accuracy accuracy : Accuracy.values()) {
                sheets.add(new Sheet(world, dimension, accuracy));
            }
        }
        truth = sheets.stream()
                .filter(sheet -> sheet.dimension == world.dimension() && sheet.accuracy == Accuracy.EXACT)
                .findFirst()
                .orElseThrow();
    }

    Needs ask() {
        List<WorldObject> robots = world.objects().stream()
                .filter(object -> object.object().isMoveable())
                .toList();
        int each = Math.max(1, PLACES / Math.max(1, robots.size()));
        int few = Math.max(1, each / FEWER);
        // If there are many robots, not all are used.
        int asked = Math.min(robots.size(), PLACES);
        for (int k = 0; k < asked; k++) {
            ask(robots.get(k), RobotReachability.isMany(robots.get(k).object()) ? few : each, k, asked);
        }
        boolean proven = !robots.isEmpty() && isProven(robots);
        Sheet enough = sheets.stream()
                .filter(sheet -> world.dimension() == Dimension.SPATIAL || sheet.dimension == Dimension.PLANAR)
                .filter(sheet -> sheet.setting().isSame())
                .findFirst()
                .orElse(truth);
        boolean told = truth.setting().isAskedEnough() && met > 0;
        return new Needs(
                told ? enough.dimension : world.dimension(),
                told ? enough.accuracy : world.accuracy(),
                proven,
                met,
                SEED,
                sheets.stream().map(Sheet::setting).toList());
    }

    private void ask(WorldObject robot, int count, int number, int robots) {
        GeometryObject home = robot.object();
        String name = String.valueOf(home.name());
        GridSearch search = reachability.search(name);
        sheets.forEach(sheet -> sheet.geometry.removeObject(name));
        int free = 0;
        for (int tries = 0; free < count && tries < count * TRIES; tries++) {
            watch.at("questions", (long) number * count + free, (long) robots * count);
            GeometryObject body = tries == 0
                    ? home
                    : tries % OF_SEARCH == 0 && search != null && search.kept() > 0
                            ? search.reached(random.nextInt(search.kept()), home)
                            : anywhere(home);
            if (mayStand(body)) {
                free++;
                move(body, name);
                listen(robot, body, name);
            }
        }
        sheets.forEach(sheet -> sheet.geometry.addObjectUnchecked(home));
    }

    private GeometryObject anywhere(GeometryObject home) {
        GeometryObject body = home.movedTo(new Point(
                (random.nextDouble() - 0.5) * world.width(),
                home.center().y(),
                (random.nextDouble() - 0.5) * world.length()));
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
        for (Sheet sheet : sheets) {
            sheet.places++;
            sheet.placesOtherwise += sheet.geometry.testObject(body) == right ? 1 : 0;
        }
        return right;
    }

    private void move(GeometryObject body, String name) {
        double way = random.nextDouble() * FAR * GridSearch.diagonal(body);
        Move move =
                random.nextBoolean() ? new Move(way, 0, 0, 0, 0) : new Move(0, 0, 0, 0, random.nextDouble(-180, 180));
        boolean right = moves(truth, body, name, move);
        met += right ? 0 : 1;
        for (Sheet sheet : sheets) {
            sheet.moves++;
            sheet.movesOtherwise += moves(sheet, body, name, move) == right ? 0 : 1;
        }
    }

    /** Adds the body, even in contact, tries the move and removes the body again. */
    private static boolean moves(Sheet sheet, GeometryObject body, String name, Move move) {
        boolean stands = sheet.geometry.addObjectUnchecked(body);
        boolean allowed = stands && sheet.geometry.move(name, move).allowed();
        sheet.geometry.removeObject(name);
        return allowed;
    }

    private void listen(WorldObject robot, GeometryObject body, String name) {
        SonarRing ring = ring(robot);
        Ray mount = ring.mount(random.nextInt(ring.count()));
        double right = hears(truth, body, name, mount, ring);
        met += Double.isFinite(right) ? 1 : 0;
        for (Sheet sheet : sheets) {
            double heard = hears(sheet, body, name, mount, ring);
            sheet.distances++;
            if (Double.compare(heard, right) != 0 && !(Math.abs(heard - right) <= slack)) {
                sheet.distancesOtherwise++;
                sheet.shortest = Math.max(sheet.shortest, heard < right ? right - heard : 0);
            }
        }
    }

    private SonarRing ring(WorldObject robot) {
        List<SonarRing> rings = robot.sonars();
        return rings.isEmpty()
                ? new SonarRing(360, 0, Double.POSITIVE_INFINITY, 0)
                : rings.get(random.nextInt(rings.size()));
    }

    private static double hears(Sheet sheet, GeometryObject body, String name, Ray mount, SonarRing ring) {
        if (!sheet.geometry.addObjectUnchecked(body)) {
            return Double.NaN;
        }
        try {
            return sheet.geometry.getSonarDistance(name, mount, ring.min(), ring.max(), ring.width());
        } catch (IllegalArgumentException vertical) {
            return Double.NaN; // a sonar of a robot lying on its side; in PLANAR it cannot point up
        } finally {
            sheet.geometry.removeObject(name);
        }
    }

    /** Whether heights cannot affect any level move or sonar. */
    private boolean isProven(List<WorldObject> robots) {
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
                && switch (object.kind()) {
                    case BOX, CYLINDER, GRID -> true;
                    case SPHERE, CAPSULE, MESH, GROUP -> false;
                };
    }
}

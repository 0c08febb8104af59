package robosim.geometry.world.check;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import robosim.geometry.Geometry;
import robosim.geometry.model.Bounds;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.Dimension;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.Point;
import robosim.geometry.model.Ray;
import robosim.geometry.world.Unit;
import robosim.geometry.world.World;
import robosim.geometry.world.WorldObject;

/**
 * What stands for a robot in a world that has none: an upright cylinder on the floor of the scene.
 *
 * <p>The floor is one of a few heights: the world's ground, the lowest point of all objects, 0, and the surfaces that lie
 * below some places. At each of them the stand-in is tried at the same random places, whether it has room, something in sight
 * and something to stand on. The floor is the lowest height that has three quarters as many of these places as the best one.
 * Where there is next to nothing to stand on, since the ground is no object, it is the world's ground if anything is in sight
 * there, 0 if several objects stand about that height, and else the lowest height at which something is in sight.
 *
 * @param body  the cylinder, a little above the floor, since what touches cannot move; moveable, and named {@value #NAME}
 * @param floor the height of the floor, world units
 */
public record SubstituteRobot(CylinderObject body, double floor) {
    /** Its name, unlike any of an object of a file. */
    static final String NAME = "stand-in of a check";

    /** Radius in metres of a robot for indoors. */
    private static final double RADIUS = 0.2;

    /** The most of the scene's smaller side that the radius may be. */
    private static final double LARGEST = 1.0 / 20;

    /** The gap below it, as a part of its height. */
    private static final double GAP = 1.0 / 32;

    private static final long SEED = 2;
    private static final int PLACES = 100;
    private static final int RAYS = 4;

    /** Heights from which floors are looked for below a place. */
    private static final int LEVELS = 4;

    private static final int MOST_FLOORS = 24;

    /** One place in so many must have a floor, or the floor is no object. */
    private static final int LEAST_STANDING = 5;

    /**
     * A stand-in for a world.
     *
     * @param geometry of the world's objects
     * @return null where there is nothing, or no place from which anything is seen
     */
    static @Nullable SubstituteRobot of(World world, Geometry geometry) {
        Bounds scene = scene(world);
        if (scene == null) {
            return null;
        }
        double side = Math.min(scene.width(), scene.length());
        double room = Math.min(world.width(), world.length());
        double size = side > 0 ? side : room / 4;
        Unit unit = world.unit();
        double radius = Math.min(size * LARGEST, unit == null ? size : RADIUS / unit.metres());
        double height = Math.min(2 * radius, world.height() / 2);
        List<Tried> all = new ArrayList<>();
        for (double floor : floors(world, geometry, scene, height * GAP)) {
            CylinderObject body = new CylinderObject(
                    new Point(scene.middleX(), floor + height * (0.5 + GAP), scene.middleZ()), radius, height);
            boolean isGround = floor == -world.height() / 2;
            all.add(tried(geometry, scene, new SubstituteRobot(body.moveable(NAME), floor), isGround));
        }
        int most = all.stream().mapToInt(Tried::standing).max().orElse(0);
        if (most * LEAST_STANDING >= PLACES) {
            return first(all, tried -> 4 * tried.standing() >= 3 * most);
        }
        SubstituteRobot ground =
                first(all, tried -> tried.standIn().floor() == -world.height() / 2 && tried.seeing() > 0);
        if (ground != null) {
            return ground;
        }
        SubstituteRobot zero = world.objects().size() == 1
                ? null
                : first(all, tried -> tried.standIn().floor() == 0 && tried.seeing() > 0);
        return zero != null ? zero : first(all, tried -> tried.seeing() > 0);
    }

    /**
     * A stand-in that was tried.
     *
     * @param seeing   at how many places it has room and sees something at its own height
     * @param standing at how many of them it has something below it
     */
    private record Tried(SubstituteRobot standIn, int seeing, int standing) {}

    private static @Nullable SubstituteRobot first(List<Tried> all, Predicate<Tried> wanted) {
        return all.stream().filter(wanted).map(Tried::standIn).findFirst().orElse(null);
    }

    /** The bounds of all that is static, or of everything if nothing is. */
    private static @Nullable Bounds scene(World world) {
        Bounds all = null;
        Bounds fixed = null;
        for (WorldObject each : world.objects()) {
            GeometryObject object = each.object();
            Bounds bounds = object.bounds();
            all = all == null ? bounds : all.and(bounds);
            if (!object.isMoveable()) {
                fixed = fixed == null ? bounds : fixed.and(bounds);
            }
        }
        return fixed == null ? all : fixed;
    }

    /**
     * The height of the floor of a world, for a robot that is to be put there.
     *
     * @return where no place is found from which anything is seen, the lowest point of the scene, since a robot below all
     *     walls would meet none; the world's ground where there is nothing, or heights do not count
     */
    public static double floorOf(World world) {
        SubstituteRobot found = of(world, world.toGeometry(refused -> {}));
        if (found != null) {
            return found.floor;
        }
        double ground = -world.height() / 2;
        Bounds scene = world.dimension() == Dimension.PLANAR ? null : scene(world);
        return scene == null ? ground : Math.max(ground, scene.minY());
    }

    /**
     * From the lowest.
     *
     * @param same how near two heights are that count as one
     */
    private static List<Double> floors(World world, Geometry geometry, Bounds scene, double same) {
        List<Double> floors = new ArrayList<>();
        double ground = -world.height() / 2;
        add(floors, ground, same);
        if (world.dimension() == Dimension.PLANAR) {
            return floors; // where heights do not count
        }
        add(floors, scene.minY(), same);
        if (scene.minY() < 0 && scene.maxY() > 0) {
            add(floors, 0, same);
        }
        SplittableRandom random = new SplittableRandom(SEED);
        for (int k = 0; k < PLACES && floors.size() < MOST_FLOORS; k++) {
            Point from = new Point(
                    scene.minX() + random.nextDouble() * scene.width(),
                    scene.minY() + (1 + k % LEVELS) * (scene.maxY() - scene.minY()) / LEVELS,
                    scene.minZ() + random.nextDouble() * scene.length());
            if (Math.abs(from.y()) <= world.height() / 2) {
                double down =
                        geometry.getRayDistance(new Ray(from, new Point(0, -1, 0)), 0, Double.POSITIVE_INFINITY, 0);
                if (down > 0 && down < Double.POSITIVE_INFINITY) {
                    add(floors, from.y() - down, same);
                }
            }
        }
        floors.sort(null);
        return floors;
    }

    /** Adds a height unless it is almost one of the others. */
    private static void add(List<Double> floors, double height, double same) {
        if (floors.stream().noneMatch(other -> Math.abs(other - height) <= same)) {
            floors.add(height);
        }
    }

    private static Tried tried(Geometry geometry, Bounds scene, SubstituteRobot standIn, boolean isGround) {
        CylinderObject body = standIn.body;
        SplittableRandom random = new SplittableRandom(SEED);
        int seeing = 0;
        int standing = 0;
        for (int k = 0; k < PLACES; k++) {
            Point at = new Point(
                    scene.minX() + random.nextDouble() * scene.width(),
                    body.center().y(),
                    scene.minZ() + random.nextDouble() * scene.length());
            CylinderObject there = body.movedTo(at);
            if (!geometry.testObject(there) && isInside(geometry, there) && seesSomething(geometry, at)) {
                seeing++;
                standing += isGround || stands(geometry, at, body.height()) ? 1 : 0;
            }
        }
        return new Tried(standIn, seeing, standing);
    }

    /** Whether there is something within two gaps below it. */
    private static boolean stands(Geometry geometry, Point center, double height) {
        double most = height * (0.5 + 2 * GAP);
        return geometry.getRayDistance(new Ray(center, new Point(0, -1, 0)), 0, Double.POSITIVE_INFINITY, 0) <= most;
    }

    private static boolean isInside(Geometry geometry, CylinderObject body) {
        Bounds b = body.bounds();
        return b.minX() >= -geometry.width() / 2
                && b.maxX() <= geometry.width() / 2
                && b.minY() >= -geometry.height() / 2
                && b.maxY() <= geometry.height() / 2
                && b.minZ() >= -geometry.length() / 2
                && b.maxZ() <= geometry.length() / 2;
    }

    private static boolean seesSomething(Geometry geometry, Point at) {
        for (int k = 0; k < RAYS; k++) {
            Point way = new Point(k == 0 ? 1 : k == 1 ? -1 : 0, 0, k == 2 ? 1 : k == 3 ? -1 : 0);
            if (Double.isFinite(geometry.getRayDistance(new Ray(at, way), 0, Double.POSITIVE_INFINITY, 0))) {
                return true;
            }
        }
        return false;
    }
}

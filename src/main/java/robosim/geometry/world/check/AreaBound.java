package robosim.geometry.world.check;

import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.Set;
import robosim.geometry.Geometry;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.CylinderObject;
import robosim.geometry.model.GeometryObject;
import robosim.geometry.model.GeometryObject.RoundedBox;
import robosim.geometry.model.Point;
import robosim.geometry.model.SphereObject;
import robosim.geometry.world.World;

/**
 * An upper bound of the area that a robot's centre can reach at its own height, by any motion and at any heading.
 *
 * <p>The plane is divided into square cells. Wherever the centre is within a cell, the robot contains its core at the middle of
 * that cell: a disc about its own axis that is smaller than the largest disc within the robot by half of a cell's diagonal. If
 * that core hits something or leaves the world, no point of the cell is reachable. A path from one cell to another crosses an
 * edge or a corner, so the cells that are reachable are among those connected to the first by cells whose core is free.
 */
final class AreaBound {
    /** The first side of a cell, as a part of the radius of the largest disc, so that a core is left; then it is halved. */
    private static final double FIRST = 1;

    private static final int LEVELS = 4;

    /** How many more cells there may be if their side is halved: four times as many, and those of ways that end. */
    private static final int GROWTH = 5;

    /** By how much a core is smaller than it may be: more than rounding changes any place or size. */
    private static final double SHRINK = 1 - 1e-9;

    /** Odd, so that no two keys become one: without it most cells have the same few hashes. */
    private static final long SPREAD = 0x9E37_79B9_7F4A_7C15L;

    private final World world;

    private final Geometry statics;

    private final CheckProgress watch;

    /** How many more cells may be looked at. */
    private int left;

    AreaBound(World world, Geometry statics, int cells, CheckProgress watch) {
        this.world = world;
        this.statics = statics;
        this.watch = watch;
        left = cells;
    }

    /** The bound for a robot; the area of the world's floor if none is found within the number of cells. */
    double of(GeometryObject robot) {
        double radius = inner(robot);
        double all = Math.max(0, world.width() - 2 * radius) * Math.max(0, world.length() - 2 * radius);
        double bound = all;
        if (!(radius > 0)) {
            return bound;
        }
        double side = FIRST * radius;
        int cells = flood(robot, radius, side);
        for (int level = 1; cells >= 0; level++) {
            bound = Math.min(bound, cells * side * side);
            if (level == LEVELS || (long) cells * GROWTH > left) {
                break;
            }
            side /= 2;
            cells = flood(robot, radius, side);
        }
        return bound;
    }

    /** The number of cells that may be reachable; -1 if there are too many to look at. */
    private int flood(GeometryObject robot, double radius, double side) {
        double coreRadius = (radius - side * Math.sqrt(0.5)) * SHRINK;
        Point start = robot.center();
        Set<Long> seen = new HashSet<>();
        ArrayDeque<Long> open = new ArrayDeque<>();
        // The robot stands in the first cell, whatever rounding does to its core.
        open.add(key(0, 0));
        seen.add(key(0, 0) * SPREAD);
        int free = 0;
        while (!open.isEmpty()) {
            long cell = open.remove();
            int i = (int) (cell >> 32);
            int j = (int) cell;
            free++;
            for (int k = 0; k < 9; k++) {
                int x = i + k % 3 - 1;
                int z = j + k / 3 - 1;
                if (!seen.add(key(x, z) * SPREAD)) {
                    continue;
                }
                if (left-- <= 0) {
                    return -1;
                }
                watch.at("the area around " + robot.name(), free, free + open.size());
                Point at = new Point(start.x() + x * side, start.y(), start.z() + z * side);
                if (isFree(robot, at, coreRadius)) {
                    open.add(key(x, z));
                }
            }
        }
        return free;
    }

    private boolean isFree(GeometryObject robot, Point at, double radius) {
        boolean isInside =
                Math.abs(at.x()) + radius <= world.width() / 2 && Math.abs(at.z()) + radius <= world.length() / 2;
        return isInside && !statics.testObject(core(robot, at, radius), Accuracy.EXACT);
    }

    private static long key(int x, int z) {
        return (long) x << 32 | (z & 0xffffffffL);
    }

    /** The radius of the largest disc about the vertical through the centre that the robot contains at all of its heights. */
    private static double inner(GeometryObject robot) {
        if (robot instanceof SphereObject sphere) {
            return sphere.radius();
        }
        if (!robot.kind().isSized() || !robot.pose().isUpright()) {
            return 0;
        }
        RoundedBox box = robot.roundedBox();
        return Math.min(box.halfWidth(), box.halfLength()) + box.radius();
    }

    private static GeometryObject core(GeometryObject robot, Point at, double radius) {
        return robot instanceof SphereObject
                ? new SphereObject(at, radius)
                : new CylinderObject(at, radius, 2 * robot.roundedBox().halfHeight() * SHRINK);
    }
}

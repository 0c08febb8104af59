package robosim.geometry.engine.sensing;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.exact.Degrees;
import robosim.geometry.index.QuadCursor;
import robosim.geometry.index.boxes.OctTree;
import robosim.geometry.index.boxes.SpaceKeys;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Cast;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafColumn;

/** Beams in a world: nearest first, and no farther than what has been found. */
public final class BeamQuery {
    /** More than what a square may lose by underflow. */
    private static final double UNDERFLOW = 0x1p-1000;

    private final ObjectTable bodies;
    private final Cast cast;

    private double ox;
    private double oy;
    private double oz;
    private double ux;
    private double uz;
    private double width;
    private double halfCos;
    private double halfSin;

    /** Where bounds begin along the beam, with their heights; among a few objects these are not worth a look. */
    private final SpaceKeys keys = new SpaceKeys();

    private static final int FEW = 4;
    private boolean hasHeights;
    private double highest;
    private int hit;
    private int hitLeaf;

    /** How many objects are remembered that a ray has been tried on. */
    private static final int RECENT = 8;

    /** By the last bits of an id: the query's number above the id. */
    private final long[] recent = new long[RECENT];

    private long query;

    /** The sides of the cone seen from above: outward normals; both zero where it has none. */
    private double leftX;

    private double leftZ;
    private double rightX;
    private double rightZ;

    public BeamQuery(ObjectTable bodies, Scratch scratch) {
        this.bodies = bodies;
        cast = new Cast(scratch);
    }

    /** The object that gave the last answer, or -1. */
    int hit() {
        return hit;
    }

    /**
     * Sets the beam. The direction is of any length but zero; in PLANAR that of its projection.
     *
     * @param openingAngle in degrees; 0 for a line
     */
    void beam(Dimension dimension, double x, double y, double z, double dx, double dy, double dz, double openingAngle) {
        cast.line(dimension, x, y, z, dx, dy, dz);
        ox = x;
        oy = y;
        oz = z;
        width = openingAngle;
        if (width > 0) {
            takeUnit();
            double cos = Degrees.cos(width / 2);
            double sin = Degrees.sin(width / 2);
            cast.widen(cos, sin);
            setSides(sin);
            halfCos = cos;
            halfSin = sin;
        }
    }

    private void takeUnit() {
        ux = cast.unit(0);
        uz = cast.unit(2);
    }

    /**
     * The cone's shadow on the XZ plane is a sector where its axis rises less than it leaves room for: the sine of the
     * half angle seen from above is that of the cone over the cosine of the axis's rise.
     */
    private void setSides(double sin) {
        double level = Math.sqrt(ux * ux + uz * uz);
        double shadow = sin * (1 + 0x1p-40) + 0x1p-40;
        if (shadow >= level) {
            leftX = 0;
            leftZ = 0;
            rightX = 0;
            rightZ = 0;
            return;
        }
        double sine = shadow / level;
        double cosine = Math.sqrt((1 - sine) * (1 + sine));
        double ax = ux / level;
        double az = uz / level;
        leftX = -sine * ax - cosine * az;
        leftZ = -sine * az + cosine * ax;
        rightX = -sine * ax + cosine * az;
        rightZ = -sine * az - cosine * ax;
    }

    /** Distance to the nearest echo, at most the limit, or +Infinity; {@link #hit()} tells whose. */
    double nearest(AccuracyView level, double limit, int but) {
        hit = -1;
        double best = width > 0 ? nearestInCone(level, limit, but) : nearestOnLine(level, limit, but);
        return best;
    }

    private double best;

    private double nearestOnLine(AccuracyView level, double limit, int but) {
        best = Double.POSITIVE_INFINITY;
        AccuracyView shared = level.shared();
        double reach = shared == null ? limit : nearestOfTrees(shared, limit, but);
        reach = nearestOfTrees(level, reach, but);
        int movers = level.moversBesideTree();
        if (movers > 0) {
            takeUnit();
        }
        for (int k = 0; k < movers; k++) {
            int id = bodies.mover(k);
            if (id != but && lineMeets(level, id, reach)) {
                reach = tryBody(level, id, reach);
            }
        }
        return best <= limit ? best : none();
    }

    /** Tries what stands in a level's trees along the line; answers how far there is still to look. */
    private double nearestOfTrees(AccuracyView level, double limit, int but) {
        int ignored = but ^ level.mark;
        double reach = nearestInStacks(level, limit, ignored);
        double dx = cast.way(0);
        double dz = cast.way(2);
        if (dx == 0 && dz == 0) {
            return nearestAboveOrBelow(level, reach, ignored);
        }
        return nearestInTree(level, reach, ignored, dx, dz);
    }

    private double nearestInTree(AccuracyView level, double limit, int but, double dx, double dz) {
        boolean isPlanar = level.dimension == Dimension.PLANAR;
        double slack = slack(level);
        double inverse = cast.inverseLength();
        double[] outlines = level.leaves().outlines();
        QuadCursor cursor = level.cursor;
        double reach = limit;
        double last = loose(reach, slack) * inverse;
        query += 1L << Integer.SIZE;
        cursor.startRay(ox, oz, dx, dz);
        for (int id = cursor.nextOnRay(last, outlines); id >= 0; id = cursor.nextOnRay(last, outlines)) {
            // What is the nearest so far comes again where it lies across regions.
            if (id != but && (id | level.mark) != hit) {
                reach = isPlanar ? tryOnPlane(level, id, outlines, reach) : tryOnce(level, id, reach);
                last = loose(reach, slack) * inverse;
            }
        }
        return reach;
    }

    private double tryOnPlane(AccuracyView level, int id, double[] outlines, double reach) {
        double found = cast.upright(outlines, id);
        if (Double.isNaN(found)) {
            return tryOnce(level, id, reach);
        }
        take(found, id | level.mark, id | LeafColumn.UPRIGHT);
        return best < reach ? best : reach;
    }

    /** Tries an object that may come again and again along a ray, as it lies across regions. */
    private double tryOnce(AccuracyView level, int id, double reach) {
        long mark = query | id;
        int place = id & (RECENT - 1);
        if (recent[place] == mark || !isAtHeight(level, id, reach)) {
            return reach;
        }
        recent[place] = mark;
        return tryBody(level, id, reach);
    }

    private double nearestAboveOrBelow(AccuracyView level, double limit, int but) {
        double reach = limit;
        level.cursor.startBox(ox, oz, ox, oz);
        for (int id = level.cursor.next(); id >= 0; id = level.cursor.next()) {
            if (id != but) {
                reach = tryBody(level, id, reach);
            }
        }
        return reach;
    }

    /**
     * The reach of the index and of bounds. A certified distance may be below the true one, and so below where the bounds
     * begin: by 2^-40 of itself in a cone, and for a cylinder by 2^-44 of its place and size, both of which the
     * world limits. What is answered at all is to be found again with its own distance as the limit.
     */
    private static double loose(double reach, double slack) {
        return reach + (0x1p-38 * reach + slack);
    }

    private double slack(AccuracyView level) {
        return 0x1p-44 * (level.extent + Math.abs(ox) + Math.abs(oz));
    }

    private double nearestInCone(AccuracyView level, double limit, int but) {
        best = Double.POSITIVE_INFINITY;
        double slack = slack(level);
        AccuracyView shared = level.shared();
        double reach = shared == null ? limit : nearestOfTreesInCone(shared, limit, but);
        reach = nearestOfTreesInCone(level, reach, but);
        for (int k = 0; k < level.moversBesideTree(); k++) {
            int id = bodies.mover(k);
            if (id != but && coneMeets(level, id, loose(reach, slack))) {
                reach = tryBody(level, id, reach);
            }
        }
        return best <= limit ? best : none();
    }

    private double nearestOfTreesInCone(AccuracyView level, double limit, int but) {
        int ignored = but ^ level.mark;
        double reach = nearestInStacks(level, limit, ignored);
        double slack = slack(level);
        level.cursor.startSector(ox, oz, leftX, leftZ, rightX, rightZ, loose(reach, slack));
        for (int id = level.cursor.next(loose(reach, slack)); id >= 0; id = level.cursor.next(loose(reach, slack))) {
            if (id != ignored && coneMeets(level, id, loose(reach, slack)) && isAtHeight(level, id, reach)) {
                reach = tryBody(level, id, reach);
            }
        }
        return reach;
    }

    /** Tries what stands in an octree, which are no moveable objects; answers how far there is still to look. */
    private double nearestInStacks(AccuracyView level, double limit, int but) {
        hasHeights = false;
        if (level.dimension == Dimension.PLANAR) {
            return limit;
        }
        OctTree.@Nullable Cursor stacked = level.spaceIndex.cursor();
        hasHeights = stacked != null || level.tree.size() > FEW;
        if (!hasHeights) {
            return limit;
        }
        takeUnit();
        double uy = cast.unit(1);
        highest = 0x1p-44 * (level.spaceIndex.most() + Math.abs(oy));
        if (width > 0) {
            keys.startCone(ox, oy, oz, ux, uy, uz, halfCos, halfSin);
        } else {
            keys.startRay(ox, oy, oz, ux, uy, uz);
        }
        double reach = limit;
        if (stacked != null) {
            double slack = slack(level) + highest;
            stacked.start(level.bounds(), keys);
            for (int id = stacked.next(loose(reach, slack)); id >= 0; id = stacked.next(loose(reach, slack))) {
                if (id != but) {
                    reach = tryBody(level, id, reach);
                }
            }
        }
        return reach;
    }

    /** Whether the beam may meet an object's bounds, with its height, within reach. */
    private boolean isAtHeight(AccuracyView level, int id, double reach) {
        return !hasHeights || keys.key(level.bounds(), 6 * id) <= loose(reach, slack(level) + highest);
    }

    private double none() {
        hit = -1;
        return Double.POSITIVE_INFINITY;
    }

    /** Looks for something nearer on one object and answers how far to look from now on. */
    private double tryBody(AccuracyView level, int id, double reach) {
        LeafColumn leaves = level.leaves();
        if (leaves.isUprightObject(id)) {
            tryLeaf(level, leaves, id, id | LeafColumn.UPRIGHT, reach);
        } else {
            int first = level.first(id);
            int last = first + level.count(id);
            for (int leaf = first; leaf < last; leaf++) {
                tryLeaf(level, leaves, id, leaf, reach);
            }
        }
        return best < reach ? best : reach;
    }

    private void tryLeaf(AccuracyView level, LeafColumn leaves, int id, int leaf, double reach) {
        take(cast.distance(leaves, leaf, best < reach ? best : reach), id | level.mark, leaf);
    }

    private void take(double found, int id, int leaf) {
        if (found < best || (found == best && hit >= 0 && bodies.isEarlier(id, hit))) {
            best = found;
            hit = id;
            hitLeaf = leaf;
        }
    }

    /** Whether the line may meet an object's bounds within reach; never wrong where it says no. */
    private boolean lineMeets(AccuracyView level, int id, double reach) {
        double[] b = level.bounds();
        int k = 6 * id;
        double mx = b[k] / 2 + b[k + 3] / 2 - ox;
        double mz = b[k + 2] / 2 + b[k + 5] / 2 - oz;
        double hx = b[k + 3] / 2 - b[k] / 2;
        double hz = b[k + 5] / 2 - b[k + 2] / 2;
        double slack = 0x1p-40 * (Math.abs(mx) + Math.abs(mz) + Math.abs(ox) + Math.abs(oz) + hx + hz);
        double aside = Math.abs(mx * uz - mz * ux);
        double ahead = mx * ux + mz * uz;
        double half = hx * Math.abs(ux) + hz * Math.abs(uz) + slack;
        return aside <= hx * Math.abs(uz) + hz * Math.abs(ux) + slack
                && ahead >= -half
                && (reach == Double.POSITIVE_INFINITY || ahead - half <= reach);
    }

    private boolean coneMeets(AccuracyView level, int id, double reach) {
        double[] b = level.bounds();
        int k = 6 * id;
        double dx = Math.max(0, Math.max(b[k] - ox, ox - b[k + 3]));
        double dz = Math.max(0, Math.max(b[k + 2] - oz, oz - b[k + 5]));
        if ((dx * dx + dz * dz) * (1 - 0x1p-50) > reach * reach + UNDERFLOW) {
            return false;
        }
        return !isBeyond(b, k, leftX, leftZ) && !isBeyond(b, k, rightX, rightZ);
    }

    /** Whether a box is wholly on the outer side of one of the cone's sides. */
    private boolean isBeyond(double[] b, int k, double nx, double nz) {
        double x = nx > 0 ? b[k] - ox : b[k + 3] - ox;
        double z = nz > 0 ? b[k + 2] - oz : b[k + 5] - oz;
        // What a certified shape is taken larger by goes with its size, not with how near its box is.
        double size = Math.abs(b[k]) + Math.abs(b[k + 2]) + Math.abs(b[k + 3]) + Math.abs(b[k + 5]);
        double slack = 0x1p-40 * (size + Math.abs(ox) + Math.abs(oz));
        return nx * x + nz * z > slack;
    }

    /** The unit normal where the line met what it hit. */
    void normal(AccuracyView level, double at, double[] out) {
        cast.normal(level.of(hit).leaves(), hitLeaf, at, out);
    }

    /** A coordinate (0 to 2) of the point on the line at a distance. */
    double point(int axis, double at) {
        return switch (axis) {
            case 0 -> ox + at * cast.unit(0);
            case 1 -> oy + at * cast.unit(1);
            default -> oz + at * cast.unit(2);
        };
    }
}

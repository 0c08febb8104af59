package robosim.geometry.narrow.distance;

import robosim.geometry.exact.FilterBound;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.BoxGap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafBounds;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.leaf.PairOrder;
import robosim.geometry.narrow.leaf.UnderflowScaling;
import robosim.geometry.narrow.leaf.UprightLeaves;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.PlanarOverlap;

/**
 * The signed distance of two convex leaves as a certified bracket, with a point on each and the direction: how far they
 * are apart, or minus how far one has to move to get out of the other.
 *
 * <p>Apart, the bracket is that of {@link Gjk}; the points are the nearest ones. Overlapping, it is that of {@link
 * Penetration}: the upper end of the depth is measured along the direction returned, the lower end is proven. The points
 * are those that the shortest translation brings together. In both cases {@code onA - onB} is the signed distance times
 * the direction, to within rounding.
 *
 * <p>(a, b) and (b, a) give the same bits, exchanged. An instance belongs to one owner of queries; a query allocates
 * nothing, except in exact decisions.
 */
public final class ConvexSeparation {
    /** The remaining gap, as a share of the sizes, at which the points of two overlapping leaves are found. */
    private static final double JUST_APART = 0x1p-40;

    private static final double DOWN = 1 - 0x1p-50;

    private final DistanceScratch s;
    private final Support first = new Support();
    private final Support second = new Support();
    private final Leaf moved = new Leaf();
    private final double[] box = new double[6];

    /** Ends of the bracket of the signed distance. */
    public double low;

    public double high;

    /** Whether the two touch or overlap, or are closer than can be decided for curved leaves. */
    public boolean touches;

    /** Points of the two leaves, to within rounding. */
    public final double[] onA = new double[3];

    public final double[] onB = new double[3];

    /** The unit direction from b towards a. */
    public final double[] direction = new double[3];

    public ConvexSeparation(DistanceScratch scratch) {
        s = scratch;
    }

    /** Measures two leaves. */
    public void measure(Dimension dimension, Leaf a, Leaf b) {
        boolean isReversed = PairOrder.isReversed(a, b);
        scaled(dimension, isReversed ? b : a, isReversed ? a : b);
        for (int axis = 0; axis < 3; axis++) {
            if (isReversed) {
                double swap = onA[axis];
                onA[axis] = onB[axis];
                onB[axis] = swap;
                direction[axis] = -direction[axis];
            }
            direction[axis] += 0.0; // no -0.0
        }
    }

    private void scaled(Dimension dimension, Leaf a, Leaf b) {
        UnderflowScaling m = s.leaf.scaling;
        if (!m.take(dimension, a, b)) {
            stored(dimension, a, b);
            return;
        }
        stored(dimension, m.first, m.second);
        low = low == 0 ? 0 : Math.nextDown(m.down(low));
        high = high == 0 ? 0 : Math.nextUp(m.down(high));
        for (int axis = 0; axis < 3; axis++) {
            onA[axis] = m.down(onA[axis]);
            onB[axis] = m.down(onB[axis]);
        }
    }

    private void stored(Dimension dimension, Leaf a, Leaf b) {
        boolean isFlat = dimension == Dimension.PLANAR;
        if (!isFlat && a.kind.isVerticalPrism() && b.kind.isVerticalPrism()) {
            upright(a, b);
            return;
        }
        double lower = nearest(isFlat, a, b);
        if (lower > 0 && !FilterBound.isDoubting()) {
            touches = false;
            low = lower;
            take(isFlat, a, b, 0);
            return;
        }
        close(dimension, a, b, lower);
    }

    /** Runs the distance query to its end; its witnesses stay until the next one. */
    private double nearest(boolean isFlat, Leaf a, Leaf b) {
        Gjk gjk = s.gjk.pair;
        double lower = isFlat ? gjk.planar(a, b) : gjk.spatial(a, b);
        return gjk.isClosed() ? lower : gjk.close();
    }

    /** Takes the upper end, the points and the direction of the last distance query, and puts the first back by a step. */
    private void take(boolean isFlat, Leaf a, Leaf b, double step) {
        Gjk gjk = s.gjk.pair;
        if (step == 0) {
            high = BoxGap.up(gjk.upper() + gjk.error());
            direction[0] = gjk.nx();
            direction[1] = gjk.ny();
            direction[2] = gjk.nz();
        }
        onA[0] = gjk.ax() - step * direction[0];
        onA[1] = gjk.ay() - step * direction[1];
        onA[2] = gjk.az() - step * direction[2];
        onB[0] = gjk.bx();
        onB[1] = gjk.by();
        onB[2] = gjk.bz();
        if (isFlat) {
            heights(a, b, 0);
        }
    }

    /** Two leaves that no slab keeps apart. */
    private void close(Dimension dimension, Leaf a, Leaf b, double lower) {
        boolean isFlat = dimension == Dimension.PLANAR;
        double nearly = BoxGap.up(s.gjk.pair.upper() + s.gjk.pair.error());
        s.overlap.uncertain = false;
        touches = ConvexOverlap.test(dimension, a, b, s.overlap);
        if (!touches && lower > 0) {
            low = lower;
            nearest(isFlat, a, b);
            take(isFlat, a, b, 0);
            return;
        }
        overlap(isFlat, a, b);
        if (!touches || s.overlap.uncertain) {
            low = touches ? low : 0;
            high = nearly;
        }
    }

    /** The bracket, direction and points of two that overlap. */
    private void overlap(boolean isFlat, Leaf a, Leaf b) {
        Penetration ways = s.gjk.penetration();
        if (isFlat) {
            ways.planar(a, b);
        } else {
            ways.spatial(a, b);
        }
        direction[0] = ways.nx(0);
        direction[1] = ways.ny(0);
        direction[2] = ways.nz(0);
        high = -Math.max(0, ways.proven()) + 0.0;
        load(isFlat, a, b);
        double depth = depth();
        double size = first.extent + second.extent;
        low = Math.min(high, -BoxGap.up(Math.max(0, depth) + Gjk.ROUNDOFF * size));
        if (!isFlat && a.kind.isVerticalPrism() && b.kind.isVerticalPrism() && direction[1] != 0) {
            nearest(true, a, b);
            takeMiddle(a, b, direction[1] > 0 ? 1 : -1);
            return;
        }
        boolean isLevel = isFlat || (a.kind.isVerticalPrism() && b.kind.isVerticalPrism());
        double step = depth + JUST_APART * size;
        MovedLeaf.moved(a, step * direction[0], step * direction[1], step * direction[2], moved);
        nearest(isLevel, moved, b);
        take(isLevel, a, b, step);
    }

    private void load(boolean isFlat, Leaf a, Leaf b) {
        double ox = Support.originX(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        if (isFlat) {
            first.planar(a.kind, a.row, a.at, ox, oz, 1);
            second.planar(b.kind, b.row, b.at, ox, oz, 1);
        } else {
            double oy = Support.originY(a.kind, a.row, a.at);
            first.spatial(a.kind, a.row, a.at, ox, oy, oz, 1);
            second.spatial(b.kind, b.row, b.at, ox, oy, oz, 1);
        }
    }

    /** How far the first has to move along the direction until the supporting planes meet. */
    private double depth() {
        double dx = direction[0];
        double dy = direction[1];
        double dz = direction[2];
        first.find(-dx, -dy, -dz);
        second.find(dx, dy, dz);
        return dx * (second.x - first.x)
                + dy * (second.y - first.y)
                + dz * (second.z - first.z)
                + first.margin
                + second.margin;
    }

    /** The greatest of n.x over the points x of a leaf, to rounding, for the direction or, if the sign is -1, its opposite. */
    public double reach(Dimension dimension, Leaf leaf, double[] along, int sign) {
        double nx = sign * along[0];
        double ny = dimension == Dimension.PLANAR ? 0 : sign * along[1];
        double nz = sign * along[2];
        load(dimension == Dimension.PLANAR, leaf, leaf);
        first.find(nx, ny, nz);
        double ox = Support.originX(leaf.kind, leaf.row, leaf.at);
        double oy = Support.originY(leaf.kind, leaf.row, leaf.at);
        double oz = Support.originZ(leaf.kind, leaf.row, leaf.at);
        double far = (ox + first.x) * nx + (oz + first.z) * nz + first.margin;
        return dimension == Dimension.PLANAR ? far : far + (oy + first.y) * ny;
    }

    /** Upright leaves in space: the plane and the heights apart, so that rims are circles. */
    private void upright(Leaf a, Leaf b) {
        Gjk gjk = s.gjk.pair;
        double aside = nearest(true, a, b);
        boolean isLevel = UprightLeaves.heightsTouch(a, b);
        if (aside > 0 && !FilterBound.isDoubting()) {
            touches = false;
            beside(a, b, aside, isLevel ? 0 : SpatialDistance.gap(a, b));
            return;
        }
        double nearly = BoxGap.up(gjk.upper() + gjk.error());
        if (!isLevel) {
            stacked(a, b, nearly);
            return;
        }
        touches = PlanarOverlap.test(a, b, s.overlap);
        if (!touches && aside > 0) {
            nearest(true, a, b);
            beside(a, b, aside, 0);
            return;
        }
        overlap(false, a, b);
        if (!touches) {
            low = 0; // closer than doubles resolve: the direction of the way out
            high = nearly;
        }
    }

    /** Two that are apart in height, with projections that overlap or are no farther apart than rounding. */
    private void stacked(Leaf a, Leaf b, double aside) {
        double gap = SpatialDistance.gap(a, b);
        double side = above(a, b) ? 1 : -1;
        touches = false;
        takeMiddle(a, b, side);
        direction[0] = 0;
        direction[1] = side;
        direction[2] = 0;
        low = gap * DOWN;
        high = BoxGap.up(aside == 0 ? gap : VectorMath.legs(aside, BoxGap.up(gap)));
    }

    /** The bracket, points and direction of two that are apart in the plane, and perhaps in height. */
    private void beside(Leaf a, Leaf b, double aside, double up) {
        Gjk gjk = s.gjk.pair;
        take(true, a, b, 0);
        low = up == 0 ? aside : VectorMath.legs(aside, up) * DOWN;
        if (up > 0) {
            high = BoxGap.up(VectorMath.legs(high, BoxGap.up(up)));
            double reach = Math.max(0, gjk.reach());
            double length = VectorMath.legs(reach, up);
            double side = above(a, b) ? 1 : -1;
            direction[0] *= reach / length;
            direction[1] = side * (up / length);
            direction[2] *= reach / length;
            heights(a, b, side);
        }
    }

    /** A common point of the projections for both, at the heights at which the two face each other. */
    private void takeMiddle(Leaf a, Leaf b, double side) {
        Gjk gjk = s.gjk.pair;
        onA[0] = 0.5 * gjk.ax() + 0.5 * gjk.bx();
        onA[2] = 0.5 * gjk.az() + 0.5 * gjk.bz();
        onB[0] = onA[0];
        onB[2] = onA[2];
        heights(a, b, side);
    }

    private static boolean above(Leaf a, Leaf b) {
        return UprightLeaves.middle(a) + UprightLeaves.top(a) > UprightLeaves.middle(b) + UprightLeaves.top(b);
    }

    /**
     * Sets the heights of both points.
     *
     * @param side 1 if a is above or leaves upwards, -1 if b does; 0 for the middle of the common heights, or of the gap
     */
    private void heights(Leaf a, Leaf b, double side) {
        LeafBounds.of(a.kind, a.row, a.at, box);
        double leastA = box[1];
        double mostA = box[4];
        LeafBounds.of(b.kind, b.row, b.at, box);
        double middle = (Math.max(leastA, box[1]) + Math.min(mostA, box[4])) / 2;
        onA[1] = side == 0 ? middle : side > 0 ? leastA : mostA;
        onB[1] = side == 0 ? middle : side > 0 ? box[4] : box[1];
    }
}

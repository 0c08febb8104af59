package robosim.geometry.narrow;

import java.util.List;

/**
 * A leaf of any kind moved straight on against one at rest: held axes (conservative advancement, van den Bergen 2004).
 *
 * <p>The gap along a fixed axis changes evenly, so an axis that tells the two apart proves them apart until that gap is
 * closed; there the next axis is looked for. Convex things' gap is a convex function of time, of which this is Newton's
 * method from the near side: it never oversteps.
 *
 * <p><b>What is certain.</b> A time is never late, and what starts apart is free only by proof: a held axis whose gap,
 * less the {@link Gjk#ROUNDOFF} of the extents and what may underflow, stays open to the end. A time may be early, and a motion that passes by may
 * be stopped, by as much as {@link Gjk} leaves open: at the time answered the gap is at most {@link #EARLY} of the sum of
 * sizes, distances and way. Where the two are closer than that at the start they count as in contact, and the least ways
 * out of {@link Penetration}, to rounding, decide whether the motion is against them.
 */
final class HeldMove {
    /** The widest gap left at the time of contact, as a share of the sum of all sizes and coordinates; seen: 2^-47. */
    static final double EARLY = 0x1p-42;

    private static final int MOST_STEPS = 200;

    /** Whether the last question found the two in contact at the start, or in doubt of it. */
    boolean contact;

    private final Support mover = new Support();
    private final Support rest = new Support();
    private final double[] pose = new double[Leaf.STRIDE];

    /** As {@link SpatialSweep#translation} and {@link PlanarSweep#translation}. */
    double time(
            boolean planar,
            int kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            int kindB,
            double[] b,
            int j,
            Scratch s) {
        Gjk gjk = s.gjk;
        double vy = planar ? 0 : dy;
        contact = false;
        if (dx == 0 && vy == 0 && dz == 0) {
            return Double.POSITIVE_INFINITY;
        }
        load(planar, kindA, a, i, kindB, b, j);
        double error = Gjk.ROUNDOFF * (mover.extent + rest.extent) + MovingAxes.TINY;
        double t = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            if (t > 1) {
                return Double.POSITIVE_INFINITY;
            }
            Poses.moved(kindA, a, i, t * dx, t * vy, t * dz, pose);
            if (planar) {
                gjk.planar(kindA, pose, 0, kindB, b, j);
            } else {
                gjk.spatial(kindA, pose, 0, kindB, b, j);
            }
            if (!(gjk.lower() > 0)) {
                if (step > 0) {
                    return t;
                }
                contact = true;
                Penetration ways = s.penetration();
                if (planar) {
                    ways.planar(kindA, a, i, kindB, b, j);
                } else {
                    ways.spatial(kindA, a, i, kindB, b, j);
                }
                return isAgainst(ways, planar, kindA, a, i, dx, vy, dz, kindB, b, j) ? 0 : Double.POSITIVE_INFINITY;
            }
            double nx = gjk.nx();
            double ny = gjk.ny();
            double nz = gjk.nz();
            mover.find(-nx, -ny, -nz);
            rest.find(nx, ny, nz);
            double gap = nx * (mover.x - rest.x)
                    + ny * (mover.y - rest.y)
                    + nz * (mover.z - rest.z)
                    - mover.margin
                    - rest.margin
                    - error;
            double slack = Gjk.ROUNDOFF * (Math.abs(dx) + Math.abs(vy) + Math.abs(dz)) + MovingAxes.TINY;
            double closing = -(nx * dx + ny * vy + nz * dz) + slack;
            if (closing <= 0 && gap - closing * t > 0) {
                return Double.POSITIVE_INFINITY;
            }
            double next = gap > 0 && closing > 0 ? gap / closing * (1 - 0x1p-51) : 0;
            if (!(next > t)) {
                return t;
            }
            t = next;
        }
        return t;
    }

    // Both from the same place, so that what is far away loses nothing.
    private void load(boolean planar, int kindA, double[] a, int i, int kindB, double[] b, int j) {
        double ox = Support.originX(kindA, a, i);
        double oy = planar ? 0 : Support.originY(kindA, a, i);
        double oz = Support.originZ(kindA, a, i);
        if (planar) {
            mover.planar(kindA, a, i, ox, oz, 1);
            rest.planar(kindB, b, j, ox, oz, 1);
        } else {
            mover.spatial(kindA, a, i, ox, oy, oz, 1);
            rest.spatial(kindB, b, j, ox, oy, oz, 1);
        }
    }

    /**
     * Whether a move is against all least ways out. What is across one, to rounding, is along it; but where it may be just
     * against all and the two only touch, the planes between them decide, without rounding.
     */
    private static boolean isAgainst(
            Penetration ways,
            boolean planar,
            int kindA,
            double[] a,
            int i,
            double dx,
            double dy,
            double dz,
            int kindB,
            double[] b,
            int j) {
        double slack = Gjk.ROUNDOFF * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
        boolean isAlong = false;
        for (int k = 0; k < ways.count(); k++) {
            double out = ways.nx(k) * dx + ways.ny(k) * dy + ways.nz(k) * dz;
            if (out >= 0) {
                return false;
            }
            isAlong |= !(out < -slack);
        }
        if (!isAlong) {
            return true;
        }
        List<ExactVector> parting = ExactFeatures.parting(planar, kindA, a, i, kindB, b, j);
        ExactVector way = ExactVector.of(dx, dy, dz);
        return !parting.isEmpty() && parting.stream().allMatch(n -> n.dot(way).signum() < 0);
    }
}

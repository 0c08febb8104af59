package robosim.geometry.narrow.sweep;

import java.util.List;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Gjk;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.gjk.Support;
import robosim.geometry.narrow.leaf.FeatureDirections;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MovedLeaf;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.OverlapScratch;
import robosim.geometry.narrow.sat.AxisBody;
import robosim.geometry.narrow.sat.ExactFeatures;

/**
 * A leaf of any kind translated against one at rest: conservative advancement with fixed separating axes (van den
 * Bergen 2004).
 *
 * <p>The gap along a fixed axis changes linearly, so a separating axis proves the two apart until that gap is closed;
 * there the next axis is searched. The gap of convex sets is a convex function of time, and this is Newton's method
 * from the near side, which never overshoots.
 *
 * <p><b>What is certain.</b> A time is never late, and leaves that start apart are free only by proof: a fixed axis
 * whose gap, less the {@link Gjk#ROUNDOFF} of the extents and what may underflow, stays open to the end. A time may be
 * early, and a motion that passes by may be stopped, by as much as {@link Gjk} leaves open: at the time answered the
 * gap is at most {@link #EARLY} of the sum of sizes, distances and way. Where the two are closer than that at the start
 * they count as in contact, and the least ways out of {@link Penetration}, to rounding, decide whether the motion is
 * against them.
 */
final class TranslationAdvancement {
    /** The widest gap left at the time of contact, as a share of the sum of all sizes and coordinates; seen: 2^-47. */
    static final double EARLY = 0x1p-42;

    private static final int MOST_STEPS = 200;

    /** Edges this close to parallel have no direction across both. */
    private static final double PARALLEL = 0x1p-40;

    /** Whether the last query found the two in contact at the start, or possibly so. */
    boolean contact;

    private final Support mover = new Support();
    private final Support rest = new Support();
    /** A gap of so many roundings is worth another look. */
    private static final double WORTH = 48;

    /** A motion runs along what it closes on by no more than this share. */
    private static final double LEVEL = 0x1p-20;

    /** An edge is square to a direction if this much of it is, the direction being off. */
    private static final double SQUARE = 0.99;

    // Steps of the search for the widest slab across an edge.
    private static final double WIDE = 0x1p-6;
    private static final double NARROW = 0x1p-24;

    private final FeatureDirections facetsA = new FeatureDirections();
    private final FeatureDirections facetsB = new FeatureDirections();
    private final Leaf pose = new Leaf();
    private double error;

    // The query: the mover and the leaf at rest, and the displacement.
    private boolean planar;
    private Leaf a = pose;
    private Leaf b = pose;
    private double dx;
    private double dy;
    private double dz;

    private final StartGap startGap = new StartGap();
    private final double[] towards = new double[3];

    /** Whether the two start nearer to each other than a sweep can resolve, and no sign says otherwise. */
    private boolean isNear;

    /** Whether the last motion was stopped by what it runs along, not into. */
    private boolean isAlong;

    /** As {@link SpatialSweep#translation} and {@link PlanarSweep#translation}. */
    double time(boolean inPlane, Leaf moving, double x, double y, double z, Leaf resting, OverlapScratch s) {
        double time = roughly(inPlane, moving, x, y, z, resting, s);
        return time > 1 ? time : fromNear(time, s);
    }

    /**
     * The time of the motion that {@link #roughly} could not prove free: infinite where it starts nearer than can be resolved, or
     * comes so near on its way along something, and is proven free without rounding. Where not even the verdict is exact, such a start counts as a contact.
     */
    private double fromNear(double time, OverlapScratch s) {
        if (!(isNear || isAlong) || (contact && isTouching(s))) {
            return time;
        }
        if (!a.kind.isEnclosure() && !b.kind.isEnclosure()) {
            startGap.between(planar, a, b);
            if (startGap.isFree(dx, dy, dz, towards)) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return time == 0 && !contact && !isExact(planar, a.kind, b.kind) ? fromContact(s) : time;
    }

    /** Whether the two certainly touch. */
    private boolean isTouching(OverlapScratch s) {
        return isExact(planar, a.kind, b.kind)
                && ConvexOverlap.test(planar ? Dimension.PLANAR : Dimension.SPATIAL, a, b, s);
    }

    /** Whether it is decided without rounding if two leaves touch. */
    private static boolean isExact(boolean planar, LeafKind kindA, LeafKind kindB) {
        if (kindA.isEnclosure() || kindB.isEnclosure()) {
            return false;
        }
        if (planar) {
            return kindA.fromAbove() != LeafKind.FromAbove.OVAL && kindB.fromAbove() != LeafKind.FromAbove.OVAL;
        }
        boolean isLongA = kindA.isCylinder() || kindA.isCapsule();
        boolean isLongB = kindB.isCylinder() || kindB.isCapsule();
        return !(isLongA && isLongB) || (kindA.isCapsule() && kindB.isCapsule());
    }

    /** The same, but for what {@link #fromNear} decides. */
    double roughly(boolean inPlane, Leaf moving, double x, double y, double z, Leaf resting, OverlapScratch s) {
        Gjk gjk = s.gjk.pair;
        planar = inPlane;
        a = moving;
        b = resting;
        dx = x;
        dy = planar ? 0 : y;
        dz = z;
        contact = false;
        isNear = false;
        isAlong = false;
        if (dx == 0 && dy == 0 && dz == 0) {
            return Double.POSITIVE_INFINITY;
        }
        load();
        error = Gjk.ROUNDOFF * (mover.extent + rest.extent) + AxisBody.TINY;
        double t = 0;
        for (int step = 0; step < MOST_STEPS; step++) {
            s.leaf.work.take();
            if (t > 1) {
                return Double.POSITIVE_INFINITY;
            }
            MovedLeaf.moved(a, t * dx, t * dy, t * dz, pose);
            if (planar) {
                gjk.planar(pose, b);
            } else {
                gjk.spatial(pose, b);
            }
            if (step == 0) {
                begin(gjk);
            }
            double next = 0;
            if (gjk.lower() > 0) {
                next = until(gjk.nx(), gjk.ny(), gjk.nz(), t);
            }
            if (!(next > t) && isInDoubt(gjk)) {
                next = near(t, gjk);
            }
            if (!(next > t)) {
                if (step > 0 && !isNear) {
                    goesAlong(gjk);
                }
                return step > 0 || gjk.lower() > 0 ? t : fromContact(s);
            }
            t = next;
        }
        return t;
    }

    private void begin(Gjk gjk) {
        double span = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        isNear = !gjk.isDeep() && gjk.lower() <= EARLY * (mover.extent + rest.extent + span) && isDirection(gjk);
    }

    /** Finds out if the motion runs along what stops it, and notes the direction. */
    private void goesAlong(Gjk gjk) {
        double closing = gjk.nx() * dx + gjk.ny() * dy + gjk.nz() * dz;
        isAlong = Math.abs(closing) <= LEVEL * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz)) && isDirection(gjk);
    }

    /** Whether a direction was found, which is noted. */
    private boolean isDirection(Gjk gjk) {
        towards[0] = gjk.nx();
        towards[1] = gjk.ny();
        towards[2] = gjk.nz();
        return Math.sqrt(gjk.nx() * gjk.nx() + gjk.ny() * gjk.ny() + gjk.nz() * gjk.nz()) > 0.5;
    }

    /** Whether there is more of a gap than rounding leaves, or a depth where none can be yet. */
    private boolean isInDoubt(Gjk gjk) {
        return !gjk.isDeep() && (gjk.upper() > WORTH * error || gjk.reach() < -error);
    }

    private double fromContact(OverlapScratch s) {
        contact = true;
        Penetration ways = s.gjk.penetration();
        double depth = planar ? ways.planar(a, b) : ways.spatial(a, b);
        return isAgainst(ways, depth <= WORTH * error) ? 0 : Double.POSITIVE_INFINITY;
    }

    /** The time until which a direction from the other to the mover proves the two apart; 0 where it proves nothing at t. */
    private double until(double nx, double ny, double nz, double t) {
        mover.find(-nx, -ny, -nz);
        rest.find(nx, ny, nz);
        double gap = nx * (mover.x - rest.x)
                + ny * (mover.y - rest.y)
                + nz * (mover.z - rest.z)
                - mover.margin
                - rest.margin
                - error;
        double slack = Gjk.ROUNDOFF * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz)) + AxisBody.TINY;
        double closing = -(nx * dx + ny * dy + nz * dz) + slack;
        if (closing <= 0 && gap - closing * t > 0) {
            return Double.POSITIVE_INFINITY;
        }
        return gap > 0 && closing > 0 ? gap / closing * (1 - 0x1p-51) : 0;
    }

    /**
     * The same of the directions that sides and edges have: close to contact that of {@link Gjk} is off by as much as a
     * rounding is large beside the gap, which counts where a flat side, a cylinder's side or an edge meets something.
     */
    private double near(double t, Gjk gjk) {
        if (planar) {
            facetsA.planar(a);
            facetsB.planar(b);
        } else {
            facetsA.spatial(a);
            facetsB.spatial(b);
        }
        double end = Math.max(sides(facetsA, t), sides(facetsB, t));
        end = Math.max(end, Math.max(edges(facetsA, gjk, t), edges(facetsB, gjk, t)));
        for (int k = 0; k < facetsA.edges; k++) {
            double px = facetsA.edgeX[k];
            double py = facetsA.edgeY[k];
            double pz = facetsA.edgeZ[k];
            for (int m = 0; m < facetsB.edges; m++) {
                double qx = facetsB.edgeX[m];
                double qy = facetsB.edgeY[m];
                double qz = facetsB.edgeZ[m];
                end = Math.max(end, both(py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx, PARALLEL, t));
            }
        }
        return end;
    }

    private double sides(FeatureDirections facets, double t) {
        double end = 0;
        for (int k = 0; k < facets.faces; k++) {
            end = Math.max(end, both(facets.faceX[k], facets.faceY[k], facets.faceZ[k], 0, t));
        }
        return end;
    }

    /** What of the direction found is square to each edge. */
    private double edges(FeatureDirections facets, Gjk gjk, double t) {
        double end = 0;
        for (int k = 0; k < facets.edges; k++) {
            double ex = facets.edgeX[k];
            double ey = facets.edgeY[k];
            double ez = facets.edgeZ[k];
            double along = gjk.nx() * ex + gjk.ny() * ey + gjk.nz() * ez;
            double x = gjk.nx() - along * ex;
            double y = gjk.ny() - along * ey;
            double z = gjk.nz() - along * ez;
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length > SQUARE) {
                end = Math.max(end, around(ex, ey, ez, x / length, y / length, z / length, t));
            }
        }
        return end;
    }

    /** The widest slab at t across an edge, looked for from a direction on. */
    private double around(double ex, double ey, double ez, double nx, double ny, double nz, double t) {
        double x = nx;
        double y = ny;
        double z = nz;
        double widest = width(x, y, z, t);
        for (double step = WIDE; step > NARROW; ) {
            double sx = step * (ey * z - ez * y);
            double sy = step * (ez * x - ex * z);
            double sz = step * (ex * y - ey * x);
            double less = width(x - sx, y - sy, z - sz, t);
            double more = width(x + sx, y + sy, z + sz, t);
            if (Math.max(less, more) > widest) {
                double way = less > more ? -1 : 1;
                widest = Math.max(less, more);
                double length = Math.sqrt(1 + step * step);
                x = (x + way * sx) / length;
                y = (y + way * sy) / length;
                z = (z + way * sz) / length;
            } else {
                step *= 0.25;
            }
        }
        return until(x, y, z, t);
    }

    private double width(double x, double y, double z, double t) {
        double length = Math.sqrt(x * x + y * y + z * z);
        mover.find(-x, -y, -z);
        rest.find(x, y, z);
        return (x * (mover.x - rest.x + t * dx) + y * (mover.y - rest.y + t * dy) + z * (mover.z - rest.z + t * dz))
                        / length
                - mover.margin
                - rest.margin;
    }

    /** A direction of any length above a least one, and the one against it. */
    private double both(double x, double y, double z, double least, double t) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > least)) {
            return 0;
        }
        double nx = x / length;
        double ny = y / length;
        double nz = z / length;
        return Math.max(until(nx, ny, nz, t), until(-nx, -ny, -nz, t));
    }

    // Both from the same place, so that what is far away loses nothing.
    private void load() {
        double ox = Support.originX(a.kind, a.row, a.at);
        double oy = planar ? 0 : Support.originY(a.kind, a.row, a.at);
        double oz = Support.originZ(a.kind, a.row, a.at);
        if (planar) {
            mover.planar(a.kind, a.row, a.at, ox, oz, 1);
            rest.planar(b.kind, b.row, b.at, ox, oz, 1);
        } else {
            mover.spatial(a.kind, a.row, a.at, ox, oy, oz, 1);
            rest.spatial(b.kind, b.row, b.at, ox, oy, oz, 1);
        }
    }

    /**
     * Whether a move is against all least ways out. What is across one, to rounding, is along it; but where it may be just
     * against all and the two only touch, and neither is an enclosure, the planes between them decide, without rounding. They
     * also decide where the two only touch, as they do in a corner, from which there are more least ways out than were found.
     *
     * @param isTouch whether they overlap by no more than may be rounding
     */
    private boolean isAgainst(Penetration ways, boolean isTouch) {
        double slack = Gjk.ROUNDOFF * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz));
        boolean isLevel = false;
        for (int k = 0; k < ways.count(); k++) {
            double out = ways.nx(k) * dx + ways.ny(k) * dy + ways.nz(k) * dz;
            if (out >= 0) {
                return false;
            }
            isLevel |= !(out < -slack);
        }
        if (!(isLevel || isTouch) || a.kind.isEnclosure() || b.kind.isEnclosure()) {
            return true;
        }
        List<ExactVector> parting = ExactFeatures.parting(planar, a, b);
        ExactVector way = ExactVector.of(dx, dy, dz);
        return parting.isEmpty()
                ? !isLevel
                : parting.stream().allMatch(n -> n.dot(way).signum() < 0);
    }
}

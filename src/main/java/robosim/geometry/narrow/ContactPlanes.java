package robosim.geometry.narrow;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import robosim.geometry.exact.ExactVector;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.Penetration;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.overlap.HeightIntervals;
import robosim.geometry.narrow.sat.ExactExtent;
import robosim.geometry.narrow.sat.ExactFeatures;
import robosim.geometry.narrow.sat.ExactSeparatingPlane;

/** The planes between two pieces that touch, computed on first use. See {@link StartContacts}. */
final class ContactPlanes {
    /** A plane normal from the other piece to the mover's, with the extents of both along it. */
    private record Plane(ExactVector normal, ExactExtent below, ExactExtent above, boolean isKept) {}

    private @Nullable List<Plane> planes;
    private boolean isComplete;

    void clear() {
        planes = null;
    }

    /**
     * Whether one of the planes separates a piece of the mover, at two places, from another piece.
     *
     * @param rows  from {@code at} on: the mover's piece in contact, at its start and end, and the piece that it
     *     touches
     */
    boolean part(
            Dimension dimension,
            Sweep motion,
            double[] rows,
            int at,
            LeafKind[] kinds,
            int kindAt,
            LeafKind kind,
            double[] from,
            int fromAt,
            LeafKind kindTo,
            double[] to,
            int toAt,
            LeafKind kindB,
            double[] b,
            int j,
            Scratch s) {
        boolean flat = dimension == Dimension.PLANAR;
        if (planes == null) {
            boolean isKnown = hasOnlyLevel(dimension, rows, at, kinds, kindAt, s);
            isComplete = true;
            planes = isKnown ? List.of() : find(flat, motion, rows, at, kinds, kindAt);
        }
        for (Plane plane : planes) {
            ExactVector n = plane.normal;
            if (plane.isKept
                    && ExactExtent.of(n, kindB, b, j).gapTo(plane.above) >= 0
                    && motion.keeps(n, kind, from, fromAt)
                    && plane.below.gapTo(ExactExtent.of(n, kind, from, fromAt)) >= 0
                    && plane.below.gapTo(ExactExtent.of(n, kindTo, to, toAt)) >= 0) {
                return true;
            }
        }
        if (isComplete || motion.isTurn()) {
            return false;
        }
        int end = at + Leaf.STRIDE;
        ExactFeatures q = new ExactFeatures(flat, kindB, b, j);
        if (q.isRound || isBeyondAll(q.corners)) {
            return false;
        }
        ExactFeatures k = new ExactFeatures(flat, kindTo, to, toAt);
        ExactFeatures i = new ExactFeatures(flat, kinds[kindAt + 1], rows, end);
        if (k.isRound || isCrossing(k.corners) || isCrossing(i.corners)) {
            return false;
        }
        ExactFeatures p = new ExactFeatures(flat, kinds[kindAt + 2], rows, end + Leaf.STRIDE);
        Set<ExactVector> upper = new LinkedHashSet<>(new ExactFeatures(flat, kinds[kindAt], rows, at).corners);
        upper.addAll(i.corners);
        upper.addAll(k.corners);
        upper.addAll(new ExactFeatures(flat, kind, from, fromAt).corners);
        List<ExactVector> first = new ArrayList<>(upper);
        int pivot = pivot(first);
        if (pivot < 0) {
            pivot = pivot(p.corners) < 0 ? -1 : first.size();
            if (pivot > 0) {
                first.add(p.corners.get(pivot(p.corners)));
            }
        }
        List<ExactVector> lower = new ArrayList<>(q.corners);
        lower.addAll(p.corners);
        return ExactSeparatingPlane.exists(first, lower, flat, pivot);
    }

    /** A corner that lies in all planes, and so in all planes between them; -1 if there is none. */
    private int pivot(List<ExactVector> corners) {
        if (planes != null && isSpanned && !planes.isEmpty()) {
            for (int k = 0; k < corners.size(); k++) {
                boolean isOnAll = true;
                for (Plane plane : planes) {
                    isOnAll &= plane.normal.dot(corners.get(k)).compareTo(plane.below.high()) == 0;
                }
                if (isOnAll) {
                    return k;
                }
            }
        }
        return -1;
    }

    /** Whether a corner of the mover ends behind all planes, and so behind all planes between them. */
    private boolean isCrossing(List<ExactVector> corners) {
        if (planes == null || !isSpanned || planes.isEmpty()) {
            return false;
        }
        for (ExactVector corner : corners) {
            boolean isBehind = true;
            for (Plane plane : planes) {
                isBehind &= plane.normal.dot(corner).compareTo(plane.below.high()) < 0;
            }
            if (isBehind) {
                return true;
            }
        }
        return false;
    }

    /** Whether the horizontal plane is certainly the only one. */
    private static boolean hasOnlyLevel(
            Dimension dimension, double[] rows, int at, LeafKind[] kinds, int kindAt, Scratch s) {
        LeafKind kindA = kinds[kindAt];
        LeafKind kindB = kinds[kindAt + 2];
        int rest = at + 2 * Leaf.STRIDE;
        if (dimension == Dimension.PLANAR || HeightIntervals.side(kindA, rows, at, kindB, rows, rest) == 0) {
            return false;
        }
        // A sphere has only one plane at a contact; so have pieces whose contact has interior points within the
        // horizontal plane.
        if ((kindA == LeafKind.SPHERE && rows[at + Leaf.SIZE] > 0)
                || (kindB == LeafKind.SPHERE && rows[rest + Leaf.SIZE] > 0)) {
            return true;
        }
        int side = HeightIntervals.side(kindA, rows, at, kindB, rows, rest);
        HeightIntervals.part(kindA, rows, at, -side, s.overlap.triangleC);
        HeightIntervals.part(kindB, rows, rest, side, s.overlap.triangleD);
        Penetration ways = s.gjk.penetration();
        ways.planar(kindA, s.overlap.triangleC, 0, kindB, s.overlap.triangleD, 0);
        return ways.proven() > 0;
    }

    /** Whether a corner is beyond all planes, and so beyond all planes between them. */
    private boolean isBeyondAll(List<ExactVector> corners) {
        if (planes == null || !isSpanned || planes.isEmpty()) {
            return false;
        }
        for (ExactVector corner : corners) {
            boolean beyond = true;
            for (Plane plane : planes) {
                beyond &= plane.normal.dot(corner).compareTo(plane.below.high()) > 0;
            }
            if (beyond) {
                return true;
            }
        }
        return false;
    }

    /** Whether every plane between the two pieces is one of those found or between them. */
    private boolean isSpanned;

    private List<Plane> find(boolean flat, Sweep motion, double[] rows, int at, LeafKind[] kinds, int kindAt) {
        int end = at + Leaf.STRIDE;
        int rest = end + Leaf.STRIDE;
        ExactFeatures mover = new ExactFeatures(flat, kinds[kindAt], rows, at);
        ExactFeatures other = new ExactFeatures(flat, kinds[kindAt + 2], rows, rest);
        List<Plane> found = new ArrayList<>();
        for (ExactVector n : ExactFeatures.parting(flat, kinds[kindAt], rows, at, kinds[kindAt + 2], rows, rest)) {
            ExactExtent above = ExactExtent.of(n, kinds[kindAt], rows, at);
            ExactExtent below = ExactExtent.of(n, kinds[kindAt + 2], rows, rest);
            boolean isKept = motion.keeps(n, kinds[kindAt], rows, at)
                    && below.gapTo(ExactExtent.of(n, kinds[kindAt + 1], rows, end)) >= 0;
            found.add(new Plane(n, below, above, isKept));
        }
        boolean hasCorners = !mover.isRound && !other.isRound;
        isSpanned = hasCorners && mover.isProper() && other.isProper();
        isComplete = !hasCorners || (isSpanned && found.size() <= 1);
        return found;
    }
}

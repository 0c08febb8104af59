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

/** Two pieces that touch, and the planes between them, computed on first use. See {@link StartContacts}. */
final class ContactPlanes {
    /** A plane normal from the other piece to the mover's, with the extents of both along it. */
    private record Plane(ExactVector normal, ExactExtent below, ExactExtent above, boolean isKept) {}

    /** The mover's piece at the start and at the end, and the piece that it touches. */
    final Leaf start = new Leaf();

    final Leaf end = new Leaf();
    final Leaf other = new Leaf();

    private @Nullable List<Plane> planes;
    private boolean isComplete;

    void clear() {
        planes = null;
    }

    /**
     * Whether one of the planes separates a piece of the mover, at two places, from another piece.
     *
     * @param from the piece at its start
     * @param to   the same at its end
     */
    boolean part(Dimension dimension, Sweep motion, Leaf from, Leaf to, Leaf b, Scratch s) {
        boolean flat = dimension == Dimension.PLANAR;
        if (planes == null) {
            boolean isKnown = hasOnlyLevel(dimension, s);
            isComplete = true;
            planes = isKnown ? List.of() : find(flat, motion);
        }
        for (Plane plane : planes) {
            ExactVector n = plane.normal;
            if (plane.isKept
                    && ExactExtent.of(n, b).gapTo(plane.above) >= 0
                    && motion.keeps(n, from)
                    && plane.below.gapTo(ExactExtent.of(n, from)) >= 0
                    && plane.below.gapTo(ExactExtent.of(n, to)) >= 0) {
                return true;
            }
        }
        if (isComplete || motion.isTurn()) {
            return false;
        }
        ExactFeatures q = new ExactFeatures(flat, b);
        if (q.isRound || isBeyondAll(q.corners)) {
            return false;
        }
        ExactFeatures k = new ExactFeatures(flat, to);
        ExactFeatures i = new ExactFeatures(flat, end);
        if (k.isRound || isCrossing(k.corners) || isCrossing(i.corners)) {
            return false;
        }
        ExactFeatures p = new ExactFeatures(flat, other);
        Set<ExactVector> upper = new LinkedHashSet<>(new ExactFeatures(flat, start).corners);
        upper.addAll(i.corners);
        upper.addAll(k.corners);
        upper.addAll(new ExactFeatures(flat, from).corners);
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
    private boolean hasOnlyLevel(Dimension dimension, Scratch s) {
        int side = dimension == Dimension.PLANAR ? 0 : HeightIntervals.side(start, other);
        if (side == 0) {
            return false;
        }
        // A sphere has only one plane at a contact; so have pieces whose contact has interior points within the
        // horizontal plane.
        if ((start.kind == LeafKind.SPHERE && start.get(Leaf.SIZE) > 0)
                || (other.kind == LeafKind.SPHERE && other.get(Leaf.SIZE) > 0)) {
            return true;
        }
        HeightIntervals.part(start, -side, s.overlap.levelA);
        HeightIntervals.part(other, side, s.overlap.levelB);
        Penetration ways = s.gjk.penetration();
        ways.planar(s.overlap.levelA, s.overlap.levelB);
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

    private List<Plane> find(boolean flat, Sweep motion) {
        ExactFeatures mover = new ExactFeatures(flat, start);
        ExactFeatures touched = new ExactFeatures(flat, other);
        List<Plane> found = new ArrayList<>();
        for (ExactVector n : ExactFeatures.parting(flat, start, other)) {
            ExactExtent above = ExactExtent.of(n, start);
            ExactExtent below = ExactExtent.of(n, other);
            boolean isKept = motion.keeps(n, start) && below.gapTo(ExactExtent.of(n, end)) >= 0;
            found.add(new Plane(n, below, above, isKept));
        }
        boolean hasCorners = !mover.isRound && !touched.isRound;
        isSpanned = hasCorners && mover.isProper() && touched.isProper();
        isComplete = !hasCorners || (isSpanned && found.size() <= 1);
        return found;
    }
}

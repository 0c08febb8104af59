package robosim.geometry.engine.motion;

import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.leaf.GridWalk;
import robosim.geometry.narrow.leaf.LeafColumn;

/** A turn of an enclosure that changes as it turns: free where what holds all of it meets nothing new or deeper. */
final class EnclosureSweep {
    private final MotionSegment segment;
    private final double[] atStart = new double[6];
    private final double[] swept = new double[6];

    /** Bounds of x + z and of x - z, for octagons. */
    private final double[] diagonals = new double[4];

    /** The bounds of what may be met, and those of its diagonals. */
    private final double[] bounds = new double[6];

    private final double[] octagon = new double[4];

    /** Made for the first grid. */
    private @Nullable GridWalk walk;

    private AccuracyView view;
    private int piece;

    /** Whether only the verdict counts, and not the time of a contact. */
    private boolean isVerdictEnough;

    @SuppressWarnings("NullAway.Init") // a question sets the view
    EnclosureSweep(MotionSegment segment) {
        this.segment = segment;
    }

    /** The cell that is met first; -1 if the object is not a grid, or is not met. */
    int piece() {
        return piece;
    }

    /**
     * The share of the turn after which an object is met, +Infinity where none is.
     *
     * @param box what holds all of the turn; the same after the call
     */
    double timeOfImpact(AccuracyView inView, int other, double[] box) {
        return impact(inView, other, box, false);
    }

    /** Whether an object is touched anywhere on the turn. */
    boolean isMet(AccuracyView inView, int other, double[] box) {
        return impact(inView, other, box, true) != Double.POSITIVE_INFINITY;
    }

    private double impact(AccuracyView inView, int other, double[] box, boolean isVerdict) {
        piece = -1;
        LeafTable table = inView.table(other);
        if (!table.overlaps(other, box)) {
            return Double.POSITIVE_INFINITY;
        }
        view = inView;
        isVerdictEnough = isVerdict;
        segment.atStart.bounds(0, segment.atStart.size(), atStart);
        LeafColumn leaves = table.leaves();
        int leaf = table.first(other);
        if (leaves.kind(leaf).isGrid()) {
            return impactOfCells(leaves, leaf, box);
        }
        System.arraycopy(table.bounds(), table.boundsAt(other), bounds, 0, 6);
        takeOctagon(leaves, leaf);
        return impact(box);
    }

    private double impactOfCells(LeafColumn leaves, int leaf, double[] box) {
        System.arraycopy(box, 0, swept, 0, 6);
        if (view.dimension == Dimension.PLANAR) {
            swept[1] = Double.NEGATIVE_INFINITY;
            swept[4] = Double.POSITIVE_INFINITY;
        }
        double least = Double.POSITIVE_INFINITY;
        GridWalk walk = this.walk;
        if (walk == null) {
            walk = new GridWalk(segment.work);
            this.walk = walk;
        }
        walk.startBox(leaves, leaf, swept);
        for (int cell = walk.nextInBox(); cell >= 0; cell = walk.nextInBox()) {
            LeafColumn own = walk.piece(cell, segment.atStart.kind(0));
            own.bounds(0, bounds);
            takeOctagon(own, 0);
            double met = impact(box);
            if (met < least) {
                least = met;
                piece = cell;
                if (isVerdictEnough) {
                    return least;
                }
            }
        }
        return least;
    }

    private void takeOctagon(LeafColumn leaves, int leaf) {
        if (view.accuracy == Accuracy.DOP) {
            System.arraycopy(leaves.rows(leaf), leaves.at(leaf) + 4, octagon, 0, 4);
        }
    }

    private double impact(double[] box) {
        takeDiagonals(0);
        double before = depth(atStart);
        if (!deepens(1, box, before)) {
            return Double.POSITIVE_INFINITY;
        }
        if (isVerdictEnough) {
            return 0;
        }
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            segment.sweptBox(middle, box);
            if (deepens(middle, box, before)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        segment.sweptBox(1, box);
        return low;
    }

    /** Whether what holds the object up to a share of the turn, a box, overlaps the other more deeply than before. */
    private boolean deepens(double share, double[] box, double before) {
        if (depthOfBoxes(box) < 0) {
            return false;
        }
        takeDiagonals(share);
        double after = depth(box);
        return after >= 0 && (before < 0 || after > before);
    }

    private void takeDiagonals(double share) {
        if (view.accuracy == Accuracy.DOP) {
            segment.sweptDiagonals(share, diagonals);
        }
    }

    /** How deeply two enclosures overlap, below 0 where they do not: along the axes and, of octagons, between them. */
    private double depth(double[] of) {
        double least = depthOfBoxes(of);
        if (view.accuracy == Accuracy.DOP) {
            for (int k = 0; k < 4; k += 2) {
                double one = diagonals[k + 1] - octagon[k];
                double two = octagon[k + 1] - diagonals[k];
                least = Math.min(least, VectorMath.HALF_ROOT * Math.min(one, two));
            }
        }
        return least;
    }

    private double depthOfBoxes(double[] of) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k += view.dimension == Dimension.PLANAR ? 2 : 1) {
            double one = of[3 + k] - bounds[k];
            double two = bounds[3 + k] - of[k];
            least = Math.min(least, Math.min(one, two));
        }
        return least;
    }
}

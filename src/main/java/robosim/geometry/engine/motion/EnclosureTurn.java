package robosim.geometry.engine.motion;

import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.exact.VectorMath;
import robosim.geometry.model.Accuracy;
import robosim.geometry.model.Dimension;

/** A turn of an enclosure that changes as it turns: free where what holds all of it meets nothing new or deeper. */
final class EnclosureTurn {
    private final Leg leg;
    private final double[] atStart = new double[6];

    /** Bounds of x + z and of x - z, for octagons. */
    private final double[] diagonals = new double[4];

    private AccuracyView view;

    @SuppressWarnings("NullAway.Init") // a question sets the view
    EnclosureTurn(Leg leg) {
        this.leg = leg;
    }

    /**
     * The share of the turn after which an object is met, +Infinity where none is.
     *
     * @param box what holds all of the turn; the same after the call
     */
    double met(AccuracyView inView, int other, double[] box) {
        if (!inView.table(other).meets(other, box)) {
            return Double.POSITIVE_INFINITY;
        }
        view = inView;
        leg.atStart.bounds(0, leg.atStart.size(), atStart);
        takeDiagonals(0);
        double before = depth(other, atStart);
        if (!deepens(other, 1, box, before)) {
            return Double.POSITIVE_INFINITY;
        }
        double low = 0;
        double high = 1;
        for (int halving = 0; halving < 50; halving++) {
            double middle = low / 2 + high / 2;
            leg.sweptBox(middle, box);
            if (deepens(other, middle, box, before)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        leg.sweptBox(1, box);
        return low;
    }

    /** Whether what holds the object up to a share of the turn, a box, overlaps another more deeply than before. */
    private boolean deepens(int other, double share, double[] box, double before) {
        if (depthOfBoxes(other, box) < 0) {
            return false;
        }
        takeDiagonals(share);
        double after = depth(other, box);
        return after >= 0 && (before < 0 || after > before);
    }

    private void takeDiagonals(double share) {
        if (view.accuracy == Accuracy.DOP) {
            leg.sweptDiagonals(share, diagonals);
        }
    }

    /** How deeply two enclosures overlap, below 0 where they do not: along the axes and, of octagons, between them. */
    private double depth(int other, double[] of) {
        double least = depthOfBoxes(other, of);
        if (view.accuracy == Accuracy.DOP) {
            LeafTable home = view.table(other);
            int leaf = home.first(other);
            double[] row = home.leaves().rows(leaf);
            int at = home.leaves().at(leaf) + 4;
            for (int k = 0; k < 4; k += 2) {
                double one = diagonals[k + 1] - row[at + k];
                double two = row[at + k + 1] - diagonals[k];
                least = Math.min(least, VectorMath.HALF_ROOT * Math.min(one, two));
            }
        }
        return least;
    }

    private double depthOfBoxes(int other, double[] of) {
        double[] b = view.table(other).bounds();
        int at = view.table(other).boundsAt(other);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k += view.dimension == Dimension.PLANAR ? 2 : 1) {
            double one = of[3 + k] - b[at + k];
            double two = b[at + 3 + k] - of[k];
            least = Math.min(least, Math.min(one, two));
        }
        return least;
    }
}

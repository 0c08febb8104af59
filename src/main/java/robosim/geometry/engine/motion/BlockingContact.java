package robosim.geometry.engine.motion;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import robosim.geometry.engine.broadphase.AccuracyView;
import robosim.geometry.engine.broadphase.Candidates;
import robosim.geometry.engine.broadphase.LeafTable;
import robosim.geometry.engine.objects.ObjectTable;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.Distance;
import robosim.geometry.narrow.MotionContact;
import robosim.geometry.narrow.Scratch;
import robosim.geometry.narrow.leaf.LeafBoxes;
import robosim.geometry.narrow.leaf.LeafColumn;

/**
 * The contact that is reported where a motion stops: all objects that the mover touches there are compared, and of those with
 * the least free share the one is chosen whose normal opposes the motion most. Nothing is computed before it is asked for.
 */
final class BlockingContact {
    private final ObjectTable objects;
    private final Candidates candidates;
    private final MotionSegment segment;
    private final Scratch scratch;
    private final Distance distance;
    private @Nullable MotionContact contacts;
    private final LeafColumn own = new LeafColumn(1);
    private final LeafColumn other = new LeafColumn(1);
    private final double[] around = new double[6];

    /** The bounds of the mover's leaves, where there are several. */
    private final LeafBoxes boxes = new LeafBoxes();

    /** The objects that share the least free share, in no order until one is chosen. */
    private int[] tied = new int[4];

    private int tiedCount;

    // The pieces that met first.
    private int ownLeaf;
    private int ownPiece;
    private int otherLeaf;
    private int otherPiece;

    BlockingContact(
            ObjectTable objects, Candidates candidates, MotionSegment segment, Scratch scratch, Distance distance) {
        this.objects = objects;
        this.candidates = candidates;
        this.segment = segment;
        this.scratch = scratch;
        this.distance = distance;
    }

    /** Takes note of an object's free share, the least before it being another one's. */
    void note(int id, double free, double least) {
        if (free > least) {
            return;
        }
        tiedCount = free < least ? 0 : tiedCount;
        if (tiedCount == tied.length) {
            tied = Arrays.copyOf(tied, 2 * tiedCount);
        }
        tied[tiedCount++] = id;
    }

    /** Sets the leaves and pieces that met first; a piece is -1 if its leaf is not made of pieces. */
    void set(int inLeaf, int inPiece, int metLeaf, int metPiece) {
        ownLeaf = inLeaf;
        ownPiece = inPiece;
        otherLeaf = metLeaf;
        otherPiece = metPiece;
    }

    /**
     * Writes the contact, six numbers; returns whose it is.
     *
     * @param share the share of the segment after which the mover is compared; NaN for its end
     */
    int contact(AccuracyView view, int obstacle, double share, double[] out) {
        if (!isTied(obstacle)) {
            note(obstacle, 0, 1); // it ends the motion by more than others are touched earlier
        }
        Arrays.sort(tied, 0, tiedCount);
        LeafColumn at = Double.isNaN(share) ? segment.atEnd() : segment.after(share);
        own.setPiece(at, ownLeaf, ownPiece);
        other.setPiece(view.table(obstacle).leaves(), otherLeaf, otherPiece);
        MotionContact all = contacts;
        if (all == null) {
            all = new MotionContact(scratch);
            contacts = all;
        }
        if (own.kind(0).hasPieces() || other.kind(0).hasPieces()) { // one is inside the other
            distance.contact(view.dimension, own, 0, other, 0, out);
            all.lean(segment.sweep, out);
            return obstacle;
        }
        all.begin(view.dimension, segment.sweep, own, other, rank(obstacle));
        at.bounds(0, at.size(), around);
        if (at.size() > 1) {
            boxes.setAll(at, 0, at.size(), view.dimension == Dimension.PLANAR);
        }
        for (int k = 0; k < 3; k++) {
            around[k] -= all.reach();
            around[3 + k] += all.reach();
        }
        for (int k = 0; k < candidates.count(); k++) {
            int id = candidates.id(k);
            if (view.table(id).overlaps(id, around)) {
                compare(all, at, view.table(id), id, id == obstacle);
            }
        }
        long chosen = all.choose(out);
        for (int k = 0; k < tiedCount; k++) {
            if (rank(tied[k]) == chosen) {
                return tied[k];
            }
        }
        return obstacle;
    }

    /** Finds the mover's leaves that may be hit at once by another leaf. */
    private int near(MotionContact all, LeafColumn at, LeafColumn others, int leaf) {
        if (at.size() == 1) {
            return 1;
        }
        others.bounds(leaf, boxes.box);
        double slack = all.reach();
        for (double bound : boxes.box) {
            slack += 0x1p-40 * Math.abs(bound); // more than rounding may make of it
        }
        return boxes.meeting(slack);
    }

    /** Adds what else of an object the mover touches. */
    private void compare(MotionContact all, LeafColumn at, LeafTable of, int id, boolean isFirst) {
        long rank = rank(id);
        int first = of.first(id);
        boolean isWhole = ownPiece < 0 && otherPiece < 0;
        for (int j = first; j < first + of.count(id); j++) {
            int near = near(all, at, of.leaves(), j);
            for (int k = 0; k < near; k++) {
                int i = at.size() == 1 ? 0 : boxes.found(k);
                boolean isKnown = isFirst && isWhole && i == ownLeaf && j == otherLeaf;
                if (!isKnown) {
                    all.add(at, i, of.leaves(), j, rank);
                }
            }
        }
    }

    /** Whether an object was noted; asked a few times only. */
    private boolean isTied(int id) {
        for (int k = 0; k < tiedCount; k++) {
            if (tied[k] == id) {
                return true;
            }
        }
        return false;
    }

    /** The arrival of one of the objects with the least free share, of which the earliest is named; -1 for others. */
    private long rank(int id) {
        return Arrays.binarySearch(tied, 0, tiedCount, id) >= 0 ? objects.arrival(id) : -1;
    }
}

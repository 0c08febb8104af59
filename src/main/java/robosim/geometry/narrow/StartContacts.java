package robosim.geometry.narrow;

import java.util.Arrays;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.HeightIntervals;
import robosim.geometry.narrow.sat.ExactFeatures;

/**
 * The contacts of a mover at the start of a motion, such as a floor that it stands on: if a plane separates the mover
 * from a piece in contact, and the motion does not cross the plane, nothing that lies wholly behind the plane blocks.
 *
 * <p>A piece q does not block a piece k of the mover if some piece i of the mover touches some piece p at the start,
 * and there is a plane with p and q on one side and, at the start, at the end as stored and in between, i and k on the
 * other; both sides are closed. This is decided on the stored numbers without rounding. For pieces with corners all
 * planes are considered; for round ones, those that touch it in a line or in a point that is not on a rim, and those of
 * caps, faces and edges ({@link ExactFeatures#normalsWith}). A turn stays on its side of a plane if it is about the
 * plane's normal or does not change the set that turns.
 *
 * <p>Horizontal planes below or above upright pieces need only sums of two doubles, and nothing is allocated.
 */
public final class StartContacts {
    private static final int ROWS = 3 * Leaf.STRIDE;

    private final Scratch s;
    private final PiecePairs pairs;
    private final MeshWalk elsewhere;
    private final double[] there = new double[Leaf.STRIDE];
    private final PiecePairs.Visitor contact = this::gather;
    private final PiecePairs.Visitor anew = this::isAnew;

    private Dimension dimension = Dimension.SPATIAL;
    private Sweep motion;
    private LeafColumn start;
    private LeafColumn end;
    private int leaf;

    /** For each contact: the mover's piece at the start and at the end, the other piece, and their kinds. */
    private double[] rows = new double[4 * ROWS];

    private LeafKind[] kinds = new LeafKind[4 * 3];
    private ContactPlanes[] planes = new ContactPlanes[4];
    private int count;

    /** The heights of horizontal contact planes, each a sum of two doubles. */
    private double[] levels = new double[8];

    private int[] sides = new int[4];
    private int levelCount;
    private boolean spares;

    private boolean isMet;
    private boolean onlyAnew;
    private int ownPiece;
    private int otherPiece;

    @SuppressWarnings("NullAway.Init") // begin sets the motion
    public StartContacts(Scratch scratch) {
        s = scratch;
        elsewhere = new MeshWalk(scratch.work);
        pairs = new PiecePairs(scratch);
    }

    /** Clears all contacts and begins a motion from a start to an end, which are read only if contacts are added. */
    public void begin(Dimension inDimension, Sweep sweep, LeafColumn atStart, LeafColumn atEnd) {
        dimension = inDimension;
        motion = sweep;
        start = atStart;
        end = atEnd;
        count = 0;
        levelCount = 0;
        spares = false;
    }

    /**
     * Whether a plane that is not horizontal has spared a piece. Which side of it a place is on depends on how the place is
     * rounded, unlike with heights, which no rounding takes out of their order.
     */
    public boolean spares() {
        return spares;
    }

    /** Whether there are no contacts at the start, except overlaps so deep that no plane separates the two. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Adds the pieces of a leaf that the mover touches at the start. */
    public void add(LeafColumn b, int j) {
        for (int i = 0; i < start.size(); i++) {
            s.work.take();
            leaf = i;
            pairs.any(dimension, start, i, b, j, contact);
        }
    }

    private boolean gather(LeafKind kindA, double[] a, int i, int t, LeafKind kindB, double[] b, int j, int u) {
        if (kindA.isEnclosure() || kindB.isEnclosure()) {
            return false; // rounded outward, so that what touches overlaps
        }
        if (!touch(kindA, a, i, kindB, b, j) || ConvexOverlap.isDeep(dimension, kindA, a, i, kindB, b, j, s.overlap)) {
            return false; // no plane separates a deep overlap
        }
        if (count == planes.length) {
            planes = Arrays.copyOf(planes, 2 * count);
            rows = Arrays.copyOf(rows, 2 * rows.length);
            kinds = Arrays.copyOf(kinds, 2 * kinds.length);
        }
        int at = count * ROWS;
        copy(a, i, at);
        LeafKind kindEnd = kindA;
        if (t >= 0) {
            elsewhere.open(end, leaf);
            elsewhere.corners(t, rows, at + Leaf.STRIDE);
        } else {
            kindEnd = end.kind(leaf);
            copy(end.rows(leaf), end.at(leaf), at + Leaf.STRIDE);
        }
        copy(b, j, at + 2 * Leaf.STRIDE);
        kinds[3 * count] = kindA;
        kinds[3 * count + 1] = kindEnd;
        kinds[3 * count + 2] = kindB;
        ContactPlanes found = planes[count];
        if (found == null) {
            found = new ContactPlanes();
            planes[count] = found;
        }
        found.clear();
        noteLevel(at, kindA, kindEnd, kindB);
        count++;
        return false;
    }

    private void copy(double[] row, int at, int to) {
        System.arraycopy(row, at, rows, to, Leaf.STRIDE);
    }

    /**
     * Records the horizontal plane that separates a contact, if there is one and the mover stays on its side; points in
     * it are on both sides.
     */
    private void noteLevel(int at, LeafKind kindA, LeafKind kindEnd, LeafKind kindB) {
        if (dimension == Dimension.PLANAR
                || !kindA.hasLevels()
                || !kindB.hasLevels()
                || !kindEnd.hasLevels()
                || !motion.keepsLevel(kindA, rows, at)) {
            return;
        }
        int b = at + 2 * Leaf.STRIDE;
        for (int side = 1; side >= -1; side -= 2) {
            double middle = HeightIntervals.middle(kindB, rows, b, side);
            double half = side * HeightIntervals.half(kindB, rows, b);
            if (HeightIntervals.isBeyond(kindA, rows, at, middle, half, side)
                    && HeightIntervals.isBeyond(kindEnd, rows, at + Leaf.STRIDE, middle, half, side)) {
                note(middle, half, side);
            }
        }
    }

    private void note(double middle, double half, int side) {
        for (int k = 0; k < levelCount; k++) {
            if (levels[2 * k] == middle && levels[2 * k + 1] == half && sides[k] == side) {
                return;
            }
        }
        if (levelCount == sides.length) {
            levels = Arrays.copyOf(levels, 4 * levelCount);
            sides = Arrays.copyOf(sides, 2 * levelCount);
        }
        levels[2 * levelCount] = middle;
        levels[2 * levelCount + 1] = half;
        sides[levelCount++] = side;
    }

    /**
     * Whether a piece does not block a piece of the mover because it is behind the plane of a contact.
     *
     * @param kindTo the mover's piece at its destination, which is the end or a place before it
     */
    boolean isBehind(
            LeafKind kind,
            double[] from,
            int at,
            LeafKind kindTo,
            double[] to,
            int atTo,
            LeafKind kindB,
            double[] b,
            int j) {
        if (isBehindLevel(kind, from, at, kindTo, to, atTo, kindB, b, j)) {
            return true;
        }
        if (count == 0) {
            return false;
        }
        HullOverlap hulls = s.gjk.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(kind, from, at);
        hulls.above(kindTo, to, atTo);
        hulls.below(kindB, b, j);
        if (hulls.areDeep()) {
            return false; // the motion goes into it, as for nearly everything that blocks
        }
        for (int k = 0; k < count; k++) {
            s.work.take();
            int row = k * ROWS;
            hulls.clear(dimension == Dimension.PLANAR);
            hulls.above(kinds[3 * k], rows, row);
            hulls.above(kinds[3 * k + 1], rows, row + Leaf.STRIDE);
            hulls.above(kind, from, at);
            hulls.above(kindTo, to, atTo);
            hulls.below(kinds[3 * k + 2], rows, row + 2 * Leaf.STRIDE);
            hulls.below(kindB, b, j);
            if (hulls.areDeep()) {
                continue;
            }
            if (planes[k].part(
                    dimension, motion, rows, row, kinds, 3 * k, kind, from, at, kindTo, to, atTo, kindB, b, j, s)) {
                spares = true;
                return true;
            }
        }
        return false;
    }

    private boolean isBehindLevel(
            LeafKind kind,
            double[] from,
            int at,
            LeafKind kindTo,
            double[] to,
            int atTo,
            LeafKind kindB,
            double[] b,
            int j) {
        if (levelCount > 0
                && kind.hasLevels()
                && kindTo.hasLevels()
                && kindB.hasLevels()
                && motion.keepsLevel(kind, from, at)) {
            for (int k = 0; k < levelCount; k++) {
                double middle = levels[2 * k];
                double half = levels[2 * k + 1];
                if (HeightIntervals.isBeyond(kind, from, at, middle, half, sides[k])
                        && HeightIntervals.isBeyond(kindTo, to, atTo, middle, half, sides[k])
                        && HeightIntervals.isBeyond(kindB, b, j, middle, half, -sides[k])) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Whether it is behind a horizontal contact plane: the part of {@link #isBehind} that needs no exact numbers and
     * decides most cases.
     */
    boolean isBehindLevel(int i, LeafKind kind, double[] from, int at, int t, LeafKind kindB, double[] b, int j) {
        if (levelCount == 0) {
            return false;
        }
        if (t < 0) {
            return isBehindLevel(kind, from, at, end.kind(i), end.rows(i), end.at(i), kindB, b, j);
        }
        elsewhere.open(end, i);
        elsewhere.corners(t, there, 0);
        return isBehindLevel(kind, from, at, kind, there, 0, kindB, b, j);
    }

    /** The same for a leaf of the mover, or a triangle of its mesh, moving to the end. */
    boolean isBehind(int i, LeafKind kind, double[] from, int at, int t, LeafKind kindB, double[] b, int j) {
        if (t < 0) {
            return isBehind(kind, from, at, end.kind(i), end.rows(i), end.at(i), kindB, b, j);
        }
        elsewhere.open(end, i);
        elsewhere.corners(t, there, 0);
        return isBehind(kind, from, at, kind, there, 0, kindB, b, j);
    }

    /**
     * The mover's triangle in the last {@link #touchesAnew}, as a position in the order of the leaves; -1 if it is not
     * a mesh.
     */
    public int ownPiece() {
        return ownPiece;
    }

    /** The same for the triangle that it touches. */
    public int otherPiece() {
        return otherPiece;
    }

    /**
     * Whether leaf i of the mover, at a place on its way, touches or overlaps a piece of leaf j that it did not touch
     * at the start and that is not behind the plane of a contact.
     */
    public boolean touchesAnew(LeafColumn at, int i, LeafColumn b, int j) {
        return touches(at, i, b, j, true);
    }

    /** The same for a place that is not on the way, where what was touched at the start counts too. */
    public boolean touchesThere(LeafColumn at, int i, LeafColumn b, int j) {
        return touches(at, i, b, j, false);
    }

    private boolean touches(LeafColumn at, int i, LeafColumn b, int j, boolean isAnew) {
        s.work.take();
        if (!Overlap.test(dimension, at, i, b, j, s)) {
            return false;
        }
        onlyAnew = isAnew;
        leaf = i;
        ownPiece = -1;
        otherPiece = -1;
        isMet = false;
        if (pairs.any(dimension, at, i, b, j, anew)) {
            return true;
        }
        // Inside a solid, without touching a face.
        return !isMet && !(isAnew && Overlap.test(dimension, start, i, b, j, s));
    }

    private boolean isAnew(LeafKind kindA, double[] a, int i, int t, LeafKind kindB, double[] b, int j, int u) {
        if (!touch(kindA, a, i, kindB, b, j)) {
            return false;
        }
        isMet = true;
        LeafKind kind = kindA;
        double[] from = there;
        int at = 0;
        if (t >= 0) {
            elsewhere.open(start, leaf);
            elsewhere.corners(t, there, 0);
        } else {
            kind = start.kind(leaf);
            from = start.rows(leaf);
            at = start.at(leaf);
        }
        if ((onlyAnew && touch(kind, from, at, kindB, b, j)) || isBehind(kind, from, at, kindA, a, i, kindB, b, j)) {
            return false;
        }
        ownPiece = t;
        otherPiece = u;
        return true;
    }

    private boolean touch(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        int known = dimension == Dimension.PLANAR ? 0 : HeightIntervals.touch(kindA, a, i, kindB, b, j, s.overlap);
        return known == 0 ? ConvexOverlap.test(dimension, kindA, a, i, kindB, b, j, s.overlap) : known > 0;
    }
}

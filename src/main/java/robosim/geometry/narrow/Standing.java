package robosim.geometry.narrow;

import java.util.Arrays;
import robosim.geometry.model.Dimension;
import robosim.geometry.narrow.gjk.HullOverlap;
import robosim.geometry.narrow.leaf.Leaf;
import robosim.geometry.narrow.leaf.LeafColumn;
import robosim.geometry.narrow.leaf.LeafKind;
import robosim.geometry.narrow.leaf.MeshWalk;
import robosim.geometry.narrow.overlap.ConvexOverlap;
import robosim.geometry.narrow.overlap.Levels;
import robosim.geometry.narrow.sat.ExactFeatures;

/**
 * What a mover stands on or leans against at the start of a motion: where such a contact has a plane between mover and piece,
 * and the motion does not cross it, nothing that lies wholly behind that plane blocks.
 *
 * <p>A piece q does not block a piece k of the mover where some piece i of the mover touches some piece p at the start and a
 * plane has p and q on its one side and, at the start, at the end as stored and in between, i and k on its other, both sides
 * closed. That is decided on the stored numbers without rounding. Whether there is such a plane is found for whatever has
 * corners, of all planes; for what is round, of those that touch it in a line or in a point that is not on a rim, and of
 * those of caps, faces and edges ({@link ExactFeatures#normalsWith}). A turn stays on its side of a plane where it is about
 * the plane's normal or does not change the set that turns.
 *
 * <p>Level planes under or over what is upright need sums of two doubles only, and nothing is allocated.
 */
public final class Standing {
    private static final int ROWS = 3 * Leaf.STRIDE;

    private final Scratch s;
    private final PiecePairs pairs;
    private final MeshWalk elsewhere = new MeshWalk();
    private final double[] there = new double[Leaf.STRIDE];
    private final PiecePairs.Visitor contact = this::gather;
    private final PiecePairs.Visitor anew = this::isAnew;

    private Dimension dimension = Dimension.SPATIAL;
    private Sweep motion;
    private LeafColumn start;
    private LeafColumn end;
    private int leaf;

    /** For each contact: the mover's piece at the start and at the end, the other's piece; and their kinds. */
    private double[] rows = new double[4 * ROWS];

    private LeafKind[] kinds = new LeafKind[4 * 3];
    private StandingPlanes[] planes = new StandingPlanes[4];
    private int count;

    /** Levels that contacts stand on, each a sum of two. */
    private double[] levels = new double[8];

    private int[] sides = new int[4];
    private int levelCount;

    private boolean isMet;
    private int ownPiece;
    private int otherPiece;

    @SuppressWarnings("NullAway.Init") // begin sets the motion
    public Standing(Scratch scratch) {
        s = scratch;
        pairs = new PiecePairs(scratch);
    }

    /** Forgets all contacts; from now on it is about a motion from a start to an end, which is read where there are some. */
    public void begin(Dimension inDimension, Sweep sweep, LeafColumn atStart, LeafColumn atEnd) {
        dimension = inDimension;
        motion = sweep;
        start = atStart;
        end = atEnd;
        count = 0;
        levelCount = 0;
    }

    /** Whether nothing that was added is touched at the start, but what is overlapped so deeply that no plane is between. */
    public boolean isEmpty() {
        return count == 0;
    }

    /** Takes in what the mover touches at the start of a leaf. */
    public void add(LeafColumn b, int j) {
        for (int i = 0; i < start.size(); i++) {
            leaf = i;
            pairs.any(dimension, start, i, b, j, contact);
        }
    }

    private boolean gather(LeafKind kindA, double[] a, int i, int t, LeafKind kindB, double[] b, int j, int u) {
        if (!touch(kindA, a, i, kindB, b, j) || ConvexOverlap.isDeep(dimension, kindA, a, i, kindB, b, j, s)) {
            return false; // no plane is between what overlaps deeply
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
        StandingPlanes found = planes[count];
        if (found == null) {
            found = new StandingPlanes();
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

    /** Notes the level that parts a contact, if one does and the mover keeps to its side; what lies in it is on both. */
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
            double middle = Levels.middle(kindB, rows, b, side);
            double half = side * Levels.half(kindB, rows, b);
            if (Levels.isBeyond(kindA, rows, at, middle, half, side)
                    && Levels.isBeyond(kindEnd, rows, at + Leaf.STRIDE, middle, half, side)) {
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
     * Whether a piece does not block a piece of the mover, because it is behind a plane of a contact.
     *
     * @param kindTo the mover's piece where it goes to, which is the end or a place before it
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
        HullOverlap hulls = s.hulls();
        hulls.clear(dimension == Dimension.PLANAR);
        hulls.above(kind, from, at);
        hulls.above(kindTo, to, atTo);
        hulls.below(kindB, b, j);
        if (hulls.areDeep()) {
            return false; // what is gone into: nearly all that blocks
        }
        for (int k = 0; k < count; k++) {
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
                if (Levels.isBeyond(kind, from, at, middle, half, sides[k])
                        && Levels.isBeyond(kindTo, to, atTo, middle, half, sides[k])
                        && Levels.isBeyond(kindB, b, j, middle, half, -sides[k])) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether it is behind a level that is stood on: what needs no exact numbers of {@link #isBehind}, and answers most. */
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

    /** The same for a leaf of the mover, or the triangle of a mesh at a place, on its way to the end. */
    boolean isBehind(int i, LeafKind kind, double[] from, int at, int t, LeafKind kindB, double[] b, int j) {
        if (t < 0) {
            return isBehind(kind, from, at, end.kind(i), end.rows(i), end.at(i), kindB, b, j);
        }
        elsewhere.open(end, i);
        elsewhere.corners(t, there, 0);
        return isBehind(kind, from, at, kind, there, 0, kindB, b, j);
    }

    /** The mover's triangle of the last {@link #touchesAnew}, a place in the order of the leaves; -1 where it is no mesh. */
    public int ownPiece() {
        return ownPiece;
    }

    /** The same of the triangle that it touches. */
    public int otherPiece() {
        return otherPiece;
    }

    /**
     * Whether leaf i of the mover, at a place on its way, touches or overlaps a piece of leaf j that it does not at the
     * start, and that is not behind a plane of a contact that was added.
     */
    public boolean touchesAnew(LeafColumn at, int i, LeafColumn b, int j) {
        if (!Overlap.test(dimension, at, i, b, j, s)) {
            return false;
        }
        leaf = i;
        ownPiece = -1;
        otherPiece = -1;
        isMet = false;
        if (pairs.any(dimension, at, i, b, j, anew)) {
            return true;
        }
        // Within a solid, and no face met.
        return !isMet && !Overlap.test(dimension, start, i, b, j, s);
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
        if (touch(kind, from, at, kindB, b, j) || isBehind(kind, from, at, kindA, a, i, kindB, b, j)) {
            return false;
        }
        ownPiece = t;
        otherPiece = u;
        return true;
    }

    private boolean touch(LeafKind kindA, double[] a, int i, LeafKind kindB, double[] b, int j) {
        int known = dimension == Dimension.PLANAR ? 0 : Levels.touch(kindA, a, i, kindB, b, j, s);
        return known == 0 ? ConvexOverlap.test(dimension, kindA, a, i, kindB, b, j, s) : known > 0;
    }
}
